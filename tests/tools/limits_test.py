# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds vertices back on the command line, and what joins them: --max-displacement, --weights, --weld-distance.
ANISOSMOOTH names the program."""

import json
import math
import random
import re
import unittest

from command_line import CommandLine

METHODS = ("paper", "bmd", "jones", "laplacian", "hc", "hc_vcglib", "taubin", "guided")


class Limits(CommandLine):
    def report(self, *arguments):
        done = self.run_tool("smooth", *arguments, "--quiet", "--report", "report.json")
        return json.loads(self.bytes_of("report.json")), done.stderr

    def text_mesh(self, weight, name="w"):
        """A noisy plane as a text PLY with one more property of the vertices; the lines of the vertices."""
        self.noisy("plane_delaunay", "400")
        self.run_tool("noise", "noisy.ply", "noisy.off", "--level", "0")
        lines = self.bytes_of("noisy.off").decode().split("\n")
        vertices, faces = map(int, lines[1].split()[:2])
        rows = [f"{line} {weight(i)}" for i, line in enumerate(lines[2:2 + vertices])]
        with open(self.path("weighted.ply"), "w", encoding="ascii") as file:
            file.write(f"ply\nformat ascii 1.0\nelement vertex {vertices}\nproperty double x\nproperty double y\n"
                       f"property double z\nproperty float {name}\nelement face {faces}\n"
                       "property list uchar int vertex_indices\nend_header\n" +
                       "".join(row + "\n" for row in rows) + "".join(line + "\n" for line in lines[2 + vertices:] if line))
        return rows

    def test_no_movement_at_all_gives_the_same_bytes(self):
        self.noisy("cad_part", "600")
        for kind in ("ply", "off", "obj", "stl"):
            self.run_tool("noise", "noisy.ply", f"in.{kind}", "--level", "0")
            for method in METHODS:
                with self.subTest(kind=kind, method=method):
                    report, _ = self.report(f"in.{kind}", f"out.{kind}", "--method", method, "--max-displacement", "0")
                    self.assertEqual(report["moved_vertices"], 0)
                    self.assertEqual(self.bytes_of(f"out.{kind}"), self.bytes_of(f"in.{kind}"))

    def test_a_largest_displacement_holds(self):
        self.noisy("cad_part", "600")
        free, _ = self.report("noisy.ply", "x.ply")
        limit = free["max_displacement"] / 2
        held, _ = self.report("noisy.ply", "x.ply", "--max-displacement", str(limit))
        self.assertEqual(held["parameters"]["max_displacement"], limit)
        self.assertNotIn("max_displacement", free["parameters"])
        self.assertLessEqual(held["max_displacement"], limit * (1 + 1e-5))
        self.assertGreater(held["bounded_vertices"], 0)

    def test_edges_of_the_file_are_creases(self):
        """A roof of 12 degrees, less than the feature angle, with noise: its ridge stays up if the file names it."""
        n = 30
        noise = random.Random(1)
        side = range(2 * n + 1)
        vertices = [(x - n, y, -math.tan(math.radians(6)) * abs(x - n) + noise.gauss(0, 0.15)) for x in side for y in side]
        faces = [(x * len(side) + y, (x + dx) * len(side) + y + dy, (x + 1) * len(side) + y + 1)
                 for x in side[:-1] for y in side[:-1] for dx, dy in ((1, 0), (0, 1))]
        faces = [f if i % 2 == 0 else (f[0], f[2], f[1]) for i, f in enumerate(faces)]
        ridge = [n * len(side) + y for y in side]
        edges = list(zip(ridge, ridge[1:]))
        heights = {}
        for name, kept in (("plain", []), ("creased", edges)):
            for kind in ("ply", "obj"):
                with open(self.path(f"{name}.{kind}"), "w", encoding="ascii") as file:
                    if kind == "ply":
                        file.write(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\nproperty double x\n"
                                   f"property double y\nproperty double z\nelement face {len(faces)}\n"
                                   f"property list uchar int vertex_indices\nelement edge {len(kept)}\n"
                                   "property int vertex1\nproperty int vertex2\nend_header\n")
                        file.write("".join("%.17g %.17g %.17g\n" % v for v in vertices))
                        file.write("".join("3 %d %d %d\n" % f for f in faces) + "".join("%d %d\n" % e for e in kept))
                    else:
                        file.write("".join("v %.17g %.17g %.17g\n" % v for v in vertices))
                        file.write("".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces))
                        file.write("".join("l %d %d\n" % (a + 1, b + 1) for a, b in kept))
                report, _ = self.report(f"{name}.{kind}", f"out.{kind}", "--method", "guided")
                self.assertEqual(report.get("crease_edges", 0), len(kept))
                lines = self.bytes_of(f"out.{kind}").decode().split("\n")
                first = lines.index("end_header") + 1 if kind == "ply" else 0
                heights[name, kind] = [float(lines[first + v].split()[-1]) for v in ridge[5:-5]]
        self.assertEqual(heights["plain", "ply"], heights["plain", "obj"])
        self.assertEqual(heights["creased", "ply"], heights["creased", "obj"])
        off = {name: sum(map(abs, heights[name, "ply"])) for name in ("plain", "creased")}
        self.assertLess(off["creased"], 0.7 * off["plain"])

    def test_weights_hold_vertices(self):
        for name in ("w", "quality"):
            rows = self.text_mesh(lambda i: 0 if i % 3 == 0 else 1, name)
            report, _ = self.report("weighted.ply", "out.ply", "--weights", name, "--boundary", "free")
            self.assertEqual(report["parameters"]["weights"], name)
            self.assertEqual(report["fixed_vertices"], (len(rows) + 2) // 3)
            after = self.bytes_of("out.ply").decode().split("\n")
            first = after.index("end_header") + 1
            for i, row in enumerate(rows):
                self.assertEqual(after[first + i] == row, i % 3 == 0, i)

    def test_bad_weights(self):
        self.text_mesh(lambda i: 2 if i == 7 else 1)
        self.expect_failure("smooth", "weighted.ply", "x.ply", "--weights", "w", says=("weight of vertex 7 is 2", "0 to 1"))
        self.expect_failure("smooth", "weighted.ply", "x.ply", "--weights", "none",
                            says=("no vertex property 'none'", "x, y, z, w"))
        self.expect_failure("smooth", "noisy.off", "x.ply", "--weights", "w", says="only PLY")

    def test_bad_lengths(self):
        self.noisy("sphere", "300")
        for option in ("weld-distance", "max-displacement"):
            for value in ("-1", "nan"):
                self.expect_failure("smooth", "noisy.ply", "x.ply", f"--{option}={value}",
                                    says=(option.replace("-", "_") + " is ", "0 or more"))
        for vertices in ("300", "3000"):
            self.noisy("sphere", vertices)
            self.expect_failure("smooth", "noisy.ply", "x.ply", "--weld-distance", "10",
                                says="well below the lengths of the edges")

    def test_a_torn_surface_names_the_remedy(self):
        corners = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
        with open(self.path("torn.stl"), "w", encoding="ascii") as file:
            file.write("solid torn\n")
            for i, face in enumerate(((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))):
                file.write("facet normal 0 0 0\nouter loop\n" +
                           "".join("vertex " + " ".join(str(x + i * 1e-6) for x in corners[v]) + "\n" for v in face) +
                           "endloop\nendfacet\n")
            file.write("endsolid torn\n")
        report, warnings = self.report("torn.stl", "x.stl")
        self.assertEqual((report["border_vertices"], report["nearly_coincident_vertices"]), (12, 12))
        distance = re.search(r"--weld-distance (\S+),", warnings).group(1)
        self.assertLess(float(distance), 1e-5)
        report, warnings = self.report("torn.stl", "x.stl", "--weld-distance", distance)
        self.assertEqual((report["border_vertices"], report["nearly_coincident_vertices"]), (0, 0))
        self.assertEqual(report["coincident_vertices"], 12)
        self.assertTrue(report["closed"])
        self.assertEqual(report["moved_vertices"], 12)
        self.assertNotIn("weld", warnings)


if __name__ == "__main__":
    unittest.main()
