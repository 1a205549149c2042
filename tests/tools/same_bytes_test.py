# SPDX-License-Identifier: GPL-3.0-or-later
"""A file that nothing moves in comes back byte for byte: generated shapes, and the folder of odd files if it is there."""

import os
import unittest

from command_line import FORMATS, CommandLine

CASES = os.environ.get("ANISO_TEST_CASES", "")
SHAPES = ("plane_slash", "plane_delaunay", "sphere", "torus", "cube", "stepped_block", "cad_part", "thin_plate",
          "thin_sheets", "graded_cube")


class SameBytes(CommandLine):
    def expect_same(self, name, odd=False):
        before = self.bytes_of(name)
        out = "same" + os.path.splitext(name)[1]
        done = self.run_tool("noise", name, out, "--level", "0", "--quiet")
        self.assertLessEqual(done.stderr.count("\n"), 1 if odd else 0, name)
        if done.stderr:
            self.assertTrue(done.stderr.startswith(f"warning: {name}: "), done.stderr)
        self.assertEqual(self.bytes_of(out), before, name)

    def test_generated_shapes(self):
        for shape in SHAPES:
            for kind in FORMATS:
                for precision in ((), ("--double",)):
                    self.run_tool("generate", shape, f"a.{kind}", "--vertices", "300", "--quiet", *precision)
                    self.expect_same(f"a.{kind}")

    def test_odd_files(self):
        """Each comes back, or is refused."""
        if not os.path.isdir(CASES):
            self.skipTest("ANISO_TEST_CASES names no folder")
        same = 0
        for folder, _, names in os.walk(CASES):
            for name in sorted(names):
                if os.path.splitext(name)[1].lower()[1:] not in FORMATS:
                    with open(os.path.join(folder, name), "rb") as file, open(self.path(name), "wb") as copy:
                        copy.write(file.read())
            for name in sorted(names):
                if os.path.splitext(name)[1].lower()[1:] not in FORMATS:
                    continue
                with open(os.path.join(folder, name), "rb") as file, open(self.path(name), "wb") as copy:
                    copy.write(file.read())
                try:
                    self.run_tool("noise", name, name, "--level", "0", "--quiet")
                except AssertionError:
                    self.expect_failure("noise", name, name, "--level", "0", "--quiet", says=name)
                    continue
                self.expect_same(name, odd=True)
                with open(os.path.join(folder, name), "rb") as file:
                    self.assertEqual(self.bytes_of(name), file.read(), name)
                same += 1
        self.assertGreater(same, 100)

    def test_a_fixed_border_and_a_selection_keep_the_bytes_of_what_stays(self):
        head = ("ply\nformat ascii 1.0\ncomment a scan\nelement vertex 9\nproperty float x\nproperty float y\n"
                "property float z\nproperty float age\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n")
        rows = [f"{x}.0 {y}.00 {'0.30' if x == y == 1 else '+0'} {x + y}" for y in range(3) for x in range(3)]
        faces = ["4 0 1 4 3", "4 1 2 5 4", "4 3 4 7 6", "4 4 5 8 7"]
        with open(self.path("a.ply"), "w") as file:
            file.write(head + "\n".join(rows + faces) + "\n")
        self.run_tool("smooth", "a.ply", "b.ply")
        lines = self.bytes_of("b.ply").decode().splitlines()
        expected = (head + "\n".join(rows + faces)).splitlines()
        different = [i for i, (a, b) in enumerate(zip(lines, expected)) if a != b]
        self.assertEqual(len(lines), len(expected))
        self.assertEqual(different, [len(head.splitlines()) + 4], "the vertex in the middle, and its line alone")
        self.assertTrue(lines[different[0]].endswith(" 2"))


if __name__ == "__main__":
    unittest.main()
