# SPDX-License-Identifier: GPL-3.0-or-later
"""Every family of bad meshes through every method of the command line: the documented error and no file, or a finite
result with all that the input had. ANISOSMOOTH and WRITE_BAD_MESHES name the programs."""

import json
import math
import os
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest

PROGRAM = os.path.abspath(os.environ["ANISOSMOOTH"])
WRITER = os.path.abspath(os.environ["WRITE_BAD_MESHES"])


def setUpModule():
    global temporary, folder, families, methods
    temporary = tempfile.TemporaryDirectory()
    folder = pathlib.Path(temporary.name)
    subprocess.run([WRITER, folder], check=True)
    families = [line.split("\t") for line in (folder / "families.txt").read_text().splitlines()]
    # The reader refuses it before the library does.
    families = [(name, "holds no vertices" if name == "empty" else error) for name, error in families]
    refused = run("smooth", "one_triangle.ply", "x.ply", "--method", "none").stderr
    methods = re.search("allowed are (.*)", refused).group(1).split(", ")


def tearDownModule():
    temporary.cleanup()


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, check=False, capture_output=True, text=True, timeout=300)


def parts(path):
    """The header, the coordinates and the faces of a PLY file as the writer makes it."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    vertices = int(re.search(rb"element vertex (\d+)", head).group(1))
    return head, struct.unpack_from(f"<{3 * vertices}f", body), body[12 * vertices:]


class BadMeshes(unittest.TestCase):
    def refused(self, done, error, output):
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(error, done.stderr)
        self.assertFalse(output.exists())

    def smooth(self, family, error, method):
        output, report = folder / "result.ply", folder / "report.json"
        for leftover in (output, report):
            leftover.unlink(missing_ok=True)
        done = run("smooth", f"{family}.ply", output.name, "--method", method, "--report", report.name, "--quiet")
        if error:
            self.refused(done, error, output)
            self.assertFalse(report.exists())
            return
        self.assertEqual(done.returncode, 0, done.stderr)
        before, after = parts(folder / f"{family}.ply"), parts(output)
        self.assertTrue(all(map(math.isfinite, after[1])))
        self.assertEqual(after[2], before[2], "faces")
        figures = json.loads(report.read_text())
        moved = sum(before[1][i:i + 3] != after[1][i:i + 3] for i in range(0, len(after[1]), 3))
        self.assertEqual((figures["vertices"], figures["moved_vertices"]), (len(after[1]) // 3, moved))

    def test_every_method(self):
        self.assertEqual(len(methods), 8)
        self.assertGreater(len(families), 30)
        for family, error in families:
            for method in methods:
                with self.subTest(family=family, method=method):
                    self.smooth(family, error, method)

    def test_distances(self):
        output = folder / "distances.ply"
        for family, error in families:
            with self.subTest(family=family):
                output.unlink(missing_ok=True)
                done = run("geodesic", f"{family}.ply", output.name, "--start-vertex", "0", "--quiet")
                if error:
                    self.refused(done, error, output)
                else:
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertTrue(output.exists())

    def test_unmerged_mesh_needs_no_merging(self):
        done = run("smooth", "unmerged.ply", "result.ply")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("weld", done.stderr)
        copies = {}
        points = [parts(folder / name)[1] for name in ("unmerged.ply", "result.ply")]
        for i in range(0, len(points[0]), 3):
            copies.setdefault(points[0][i:i + 3], set()).add(points[1][i:i + 3])
        self.assertTrue(all(len(places) == 1 and places != {place} for place, places in copies.items()))


if __name__ == "__main__":
    unittest.main()
