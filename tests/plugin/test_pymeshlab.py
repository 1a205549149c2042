# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin inside PyPI's PyMeshLab: all filters, by apply_filter and as methods, on a mesh with all that a mesh carries.
Run by scripts/test_pymeshlab. ANISO_PLUGIN and ANISOSMOOTH name plugin and command line."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np
import pymeshlab

SNAPSHOT = json.loads(pathlib.Path(__file__).with_name("filters.json").read_text())
METHODS = {"apply_coord_anisotropic_smoothing": "paper", "apply_coord_bilateral_denoising": "bmd",
           "apply_coord_non_iterative_smoothing": "jones", "apply_coord_guided_anisotropic_smoothing": "guided"}
GEODESIC = "compute_scalar_by_virtual_source_geodesic"
VALUES = {"sigma_c": 2.5, "sigma_s": 0.75, "sigma_n": 0.25, "rho": 1.75, "iterations": 2, "strength": 0.5,
          "feature_angle": 40.0, "boundary": "free"}
EXTRAS = ("vertex_color_matrix", "vertex_scalar_array", "wedge_tex_coord_matrix", "face_matrix",
          "vertex_selection_array", "face_selection_array")


def setUpModule():
    pymeshlab.load_plugin(os.environ["ANISO_PLUGIN"])
    for name in [*METHODS, GEODESIC]:
        setattr(pymeshlab.MeshSet, name, pymeshlab.bind_function(name))


class InPyMeshLab(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        # Text counts as double precision, and so does the binary file that is made of it.
        self.run_tool("generate", "cad_part", "clean.obj", "--vertices", "3000")
        self.run_tool("noise", "clean.obj", "noisy.ply", "--level", "0.2")

    def run_tool(self, *arguments):
        return subprocess.run([os.environ["ANISOSMOOTH"], *arguments], cwd=self.folder, check=True, capture_output=True,
                              text=True)

    def load(self, name="noisy.ply"):
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(str(self.folder / name))
        return meshes

    def dressed(self):
        """The noisy mesh with colours, quality and texture coordinates."""
        meshes = self.load()
        meshes.compute_scalar_by_function_per_vertex(q="x + 2 * y")
        meshes.compute_color_by_function_per_vertex(x="128 + 90 * x", y="60", z="200", a="255")
        meshes.compute_texcoord_parametrization_triangle_trivial_per_wedge(textdim=4096)
        return meshes

    def by_command_line(self, method, *options):
        """Positions and report of the same filter on the same file."""
        self.run_tool("smooth", "noisy.ply", "expected.ply", "--method", method, "--report", "report.json", "--quiet",
                      *options)
        meshes = self.load("expected.ply")  # it owns the mesh
        return meshes.current_mesh().vertex_matrix().copy(), json.loads((self.folder / "report.json").read_text())

    def assert_report(self, report, name, expected):
        (snapshot,) = [one for one in SNAPSHOT if one["python_name"] == name]
        self.assertLessEqual(set(snapshot["report"]), set(report))
        for key, value in report.items():
            if key == "skipped_vertices":
                value = value - sum(expected[key].values())
                self.assertEqual(value, 0)
            elif key in expected:
                self.assertEqual(value, expected[key], key)
        self.assertGreater(report["moved_vertices"], 0)

    def test_gives_the_bits_of_the_command_line(self):
        for name, method in METHODS.items():
            (snapshot,) = [one for one in SNAPSHOT if one["python_name"] == name]
            known = {one["python_name"] for one in snapshot["parameters"]}
            keywords = {key: value for key, value in VALUES.items() if key in known}
            options = [text for key, value in keywords.items() for text in ("--" + key.replace("_", "-"), str(value))]
            for given, words in (({}, []), (keywords, options)):
                with self.subTest(filter=name, given=given):
                    expected, figures = self.by_command_line(method, *words)
                    meshes = self.load()
                    self.assert_report(meshes.apply_filter(name, **given), name, figures)
                    np.testing.assert_array_equal(meshes.current_mesh().vertex_matrix(), expected)
                    meshes = self.load()
                    self.assert_report(getattr(meshes, name)(**given), name, figures)
                    np.testing.assert_array_equal(meshes.current_mesh().vertex_matrix(), expected)

    def test_leaves_the_rest_of_the_mesh(self):
        for name in METHODS:
            with self.subTest(filter=name):
                meshes = self.dressed()
                mesh = meshes.current_mesh()
                before = {extra: getattr(mesh, extra)().copy() for extra in EXTRAS}
                positions = mesh.vertex_matrix().copy()
                meshes.apply_filter(name)
                for extra in EXTRAS:
                    np.testing.assert_array_equal(getattr(mesh, extra)(), before[extra], extra)
                self.assertGreater((mesh.vertex_matrix() != positions).any(axis=1).mean(), 0.9)

    def test_moves_what_is_selected(self):
        for name in METHODS:
            with self.subTest(filter=name):
                meshes = self.load()
                meshes.compute_selection_by_condition_per_vertex(condselect="x > 0")
                mesh = meshes.current_mesh()
                selected = mesh.vertex_selection_array().copy()
                positions = mesh.vertex_matrix().copy()
                self.assertTrue(0 < selected.sum() < len(selected))
                meshes.apply_filter(name, selected=True)
                moved = (mesh.vertex_matrix() != positions).any(axis=1)
                self.assertFalse((moved & ~selected).any())
                self.assertGreater(moved[selected].mean(), 0.9)
                np.testing.assert_array_equal(mesh.vertex_selection_array(), selected)

    def test_smooths_colours_on_request(self):
        meshes = self.dressed()
        mesh = meshes.current_mesh()
        quality = mesh.vertex_scalar_array().copy()
        meshes.apply_coord_guided_anisotropic_smoothing(smooth_color=True)
        self.assertTrue((mesh.vertex_scalar_array() != quality).any())

    def test_geodesic_distances_are_the_command_lines(self):
        self.run_tool("geodesic", "noisy.ply", "distance.ply", "--start-vertex", "7", "--isolines", "5")
        distances = self.load("distance.ply")
        expected = distances.current_mesh().vertex_scalar_array().copy()
        for run in ("apply_filter", "method"):
            meshes = self.load()
            values = {"start_vertex": 7, "isolines": 5}
            report = meshes.apply_filter(GEODESIC, **values) if run == "apply_filter" else (
                meshes.compute_scalar_by_virtual_source_geodesic(**values))
            np.testing.assert_array_equal(meshes.current_mesh().vertex_scalar_array(), expected)
            self.assertEqual(report["max_distance"], expected.max())
            self.assertEqual(report["unreachable_vertices"], 0)

    def test_says_what_is_wrong(self):
        meshes = self.load()
        positions = meshes.current_mesh().vertex_matrix().copy()
        for keywords, words in (({"sigma_c": -1.0}, "sigma_c is -1"), ({"boundary": "loose"}, "'fixed'; 'free'"),
                                ({"sigma": 1.0}, "sigma")):
            with self.assertRaisesRegex((pymeshlab.PyMeshLabException, pymeshlab.InvalidEnumException), words):
                meshes.apply_filter("apply_coord_anisotropic_smoothing", **keywords)
        np.testing.assert_array_equal(meshes.current_mesh().vertex_matrix(), positions)
        empty = pymeshlab.MeshSet()
        empty.add_mesh(pymeshlab.Mesh(np.zeros((3, 3))))
        with self.assertRaisesRegex(pymeshlab.PyMeshLabException, "(?i)faces"):
            empty.apply_filter("apply_coord_anisotropic_smoothing")


if __name__ == "__main__":
    unittest.main()
