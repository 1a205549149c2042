# SPDX-License-Identifier: GPL-3.0-or-later
"""The guided filter in pieces: it sets itself by the whole mesh, and each piece has to be told."""

import math
import os
import random
import shutil
import subprocess
import unittest

from command_line import PROGRAM
from ply_numbers import Ply
from tiles_test import Tiles


class GuidedTiles(Tiles):
    # Vertices that are just held back, or faces just turned over, may be on the other side of a limit.
    nearly_equal_counts = ("moved_vertices", "bounded_vertices", "flipped_faces", "beyond_ring_vertices")

    def plan(self, mesh="noisy.ply", plan="plan", tile_vertices="2000", *options):
        return super().plan(mesh, plan, tile_vertices, "--method", "guided", *options)

    def whole(self, mesh="noisy.ply", out="whole.ply", *options):
        self.run_tool("smooth", mesh, out, "--method", "guided", "--report", "whole.json", *options)

    def expect_same_in_pieces(self, mesh, tile_vertices, least_pieces, *options):
        self.whole(mesh, "whole.ply", *options)
        self.in_pieces(mesh, "pieces.ply", str(tile_vertices), *options)
        self.assertGreaterEqual(len(self.pieces()), least_pieces)
        self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-3)
        self.expect_same_report()


def folded_ribbon(rows, columns=9, rows_to_a_fold=40):
    """A noisy zigzag of right angles with a hole here and there: (rows * columns) vertices with edges of about 1."""
    random.seed(5)
    vertices, x, y = [], 0.0, 0.0
    for row in range(rows):
        for column in range(columns):
            place = (x, y, float(column))
            vertices.append(tuple(coordinate + random.gauss(0, 0.15) for coordinate in place))
        upwards = row // rows_to_a_fold % 2
        x, y = (x, y + 1) if upwards else (x + 1, y)
    faces = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            if column == 3 and row % 25 == 10:
                continue
            a = row * columns + column
            faces += [(a, a + columns, a + 1), (a + 1, a + columns, a + columns + 1)]
    return Ply(vertices, faces)


class SameResult(GuidedTiles):
    def test_edges_and_holes(self):
        self.noisy("cad_part", "10000")
        for pieces in (2, 16):
            with self.subTest(pieces=pieces):
                self.expect_same_in_pieces("noisy.ply", 10000 // pieces, pieces // 2)

    def test_thin_parts_without_the_blend(self):
        self.noisy("thin_plate", "10000")
        self.expect_same_in_pieces("noisy.ply", 2500, 4, "--blend", "off")

    def test_uneven_edges(self):
        self.noisy("graded_cube", "10000")
        self.expect_same_in_pieces("noisy.ply", 3000, 3)

    def test_borders(self):
        self.noisy("plane_delaunay", "10000")
        self.expect_same_in_pieces("noisy.ply", 3000, 3, "--boundary", "fixed", "--strength", "0.8")

    def test_two_hundred_pieces(self):
        folded_ribbon(2400).write(self.path("noisy.ply"))
        self.expect_same_in_pieces("noisy.ply", 2400 * 9 // 200, 100)

    def test_medians_by_pieces(self):
        """A mesh that the plan does not look at in one piece."""
        self.noisy("cad_part", "40000")
        self.expect_same_in_pieces("noisy.ply", 20000, 2)

    def test_stairs_of_voxels(self):
        self.run_tool("generate", "voxel_sphere", "noisy.ply", "--vertices", "20000", "--tilt", "20")
        self.expect_same_in_pieces("noisy.ply", 5000, 4)
        self.assertGreater(self.json("whole.json")["estimated_noise"], 0)

    def test_clean_mesh_keeps_its_bytes(self):
        self.run_tool("generate", "cad_part", "clean.ply", "--vertices", "10000")
        self.expect_same_in_pieces("clean.ply", 3000, 3)
        self.assertEqual(self.bytes_of("pieces.ply"), self.bytes_of("clean.ply"))
        self.assertEqual(self.json("pieces.json")["estimated_noise"], 0)

    def test_correlated_noise(self):
        self.run_tool("generate", "stepped_block", "clean.ply", "--vertices", "12000")
        self.run_tool("noise", "clean.ply", "noisy.ply", "--level", "0.2", "--correlation", "2")
        self.expect_same_in_pieces("noisy.ply", 4000, 3)
        report = self.json("pieces.json")
        self.assertAlmostEqual(report["estimated_noise"] / report["average_edge_length"], 0.2, delta=0.05)

    def test_noise_in_one_half(self):
        self.noisy("torus", "12000")
        noisy, clean = Ply.read(self.path("noisy.ply")), Ply.read(self.path("clean.ply"))
        noisy.vertices = [p if p[0] > 0 else q for p, q in zip(noisy.vertices, clean.vertices)]
        noisy.write(self.path("half.ply"))
        self.expect_same_in_pieces("half.ply", 3000, 4)

    def test_shuffled_order(self):
        self.noisy("torus", "12000")
        mesh, order = Ply.read(self.path("noisy.ply")).shuffled()
        mesh.write(self.path("shuffled.ply"))
        self.whole()
        self.in_pieces("shuffled.ply", "pieces.ply", "4000")
        whole, pieces = Ply.read(self.path("whole.ply")), Ply.read(self.path("pieces.ply"))
        limit = 1e-3 * whole.average_edge_length()
        far = [i for i, old in enumerate(order) if math.dist(whole.vertices[old], pieces.vertices[i]) > limit]
        self.assertLessEqual(len(far), len(order) // 10000)

    def test_stl(self):
        self.noisy("cad_part", "6000")
        self.run_tool("noise", "noisy.ply", "noisy.stl", "--level", "0")
        self.whole("noisy.stl", "whole.stl")
        self.in_pieces("noisy.stl", "pieces.stl", "12000")
        self.run_tool("noise", "whole.stl", "whole.ply", "--level", "0")
        self.run_tool("noise", "pieces.stl", "pieces.ply", "--level", "0")
        self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-3)

    def test_points_and_rounds_that_are_asked_for(self):
        """One round, which is not the paper's one pass; tiles without any face."""
        self.noisy("torus", "3000")
        mesh = Ply.read(self.path("noisy.ply"))
        mesh.vertices += [(50.0 + i, 0.0, 0.0) for i in range(300)]
        mesh.write(self.path("points.ply"))
        self.expect_same_in_pieces("points.ply", 400, 3, "--iterations", "1", "--max-displacement", "0.01")

    @unittest.skipIf(os.environ.get("ANISO_SANITIZE"), "sanitizers take memory of their own")
    def test_memory_limit(self):
        self.noisy("torus", "120000")
        self.whole()
        limit = 120
        process = subprocess.Popen([PROGRAM, "smooth", "noisy.ply", "pieces.ply", "--method", "guided", "--memory",
                                    f"{limit}M", "--report", "pieces.json"], cwd=self.folder, text=True,
                                   stderr=subprocess.PIPE)
        said = process.stderr.read()
        process.stderr.close()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0, said)
        self.assertIn("in pieces", said)
        self.assertLessEqual(usage.ru_maxrss, limit * 1024)
        self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-3)
        self.expect_same_report()
        self.expect_failure("smooth", "noisy.ply", "out.ply", "--method", "guided", "--memory", "80M", "--quiet",
                            says="needs at least")


class Determinism(GuidedTiles):
    def test_order_workers_and_restart_make_no_difference(self):
        self.noisy("cad_part", "8000")
        self.in_pieces("noisy.ply", "first.ply", "1500")
        count = len(self.pieces())
        plan = self.bytes_of("plan/plan.json")
        shutil.rmtree(self.path("plan"))
        self.plan("noisy.ply", "plan", "1500")
        self.assertEqual(self.bytes_of("plan/plan.json"), plan)
        self.expect_by_workers("first.ply")
        self.assertEqual(sorted(os.listdir(self.path("plan"))),
                         sorted(["plan.json", *(f"{kind}_{i}" for kind in ("bucket", "result") for i in range(count))]))


if __name__ == "__main__":
    unittest.main()
