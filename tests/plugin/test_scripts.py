# SPDX-License-Identifier: GPL-3.0-or-later
"""Filter scripts in MeshLab, by 2020.09's meshlabserver or, since 2021, by our apply_mlx: same vertices as the command
line, nothing else touched, clear failures."""

import json
import pathlib
import struct
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "support"))

import decimal_comma  # noqa: E402
import ply  # noqa: E402
import scripts  # noqa: E402
from environment import APPLY_MLX, Display, fresh_work_folder, make_meshlab, run_tool  # noqa: E402

SELECTED = 0x20  # vcglib's bit for "selected" in the flags of vertices and faces
ATTRIBUTES = ("-m", "vc", "vf", "vq", "vt", "fc", "ff", "fq", "wt")


def setUpModule():
    global work, meshlab, display, noisy, sheets
    work = fresh_work_folder()
    meshlab = make_meshlab(work)
    display = Display().__enter__()
    noisy = make_noisy("cad_part", 35000)
    sheets = make_noisy("thin_sheets", 2000)  # has borders


def tearDownModule():
    display.__exit__()


def make_noisy(shape, vertices):
    clean = work / f"{shape}.ply"
    result = work / f"{shape}_noisy.ply"
    run_tool("generate", shape, clean, "--vertices", vertices)
    run_tool("noise", clean, result, "--level", "0.2", "--seed", "1")
    return result


def with_attributes(source, target):
    """The mesh of `source` with colour, quality, texture coordinates and a selection on vertices, faces and corners."""
    vertex = ply.read(source)["vertex"]
    x, y, z = (ply.floats(vertex[name]) for name in "xyz")
    vertices = [(x[i], y[i], z[i], SELECTED if i % 3 == 0 else 0, i % 256, i // 256 % 256, i * 7 % 256, 255, 0.25 * i,
                 i % 10 / 10, i % 7 / 7) for i in range(len(x))]
    faces = [(corners, SELECTED if i % 5 == 0 else 0, i * 3 % 256, i % 256, 9, 255, 0.5 * i, [0.1 * (i % 9)] * 6)
             for i, corners in enumerate(ply.triangles(source))]
    colors = [(channel, "uchar") for channel in ("red", "green", "blue", "alpha")]
    ply.write(target, [
        ("vertex", [("x", "float"), ("y", "float"), ("z", "float"), ("flags", "int"), *colors, ("quality", "float"),
                    ("texture_u", "float"), ("texture_v", "float")], vertices),
        ("face", [("vertex_indices", ("uchar", "int")), ("flags", "int"), *colors, ("quality", "float"),
                  ("texcoord", ("uchar", "float"))], faces)], comments=["TextureFile none.png"])
    return target


def serve(source, name, filter_name=scripts.SMOOTHING, save=(), **values):
    """Runs one filter; returns the finished process and the output's path."""
    script = scripts.write(work / f"{name}.mlx", filter_name, **values)
    target = work / f"{name}.ply"
    return meshlab.apply(display.name, script, source, target, save), target


class Smoothing(unittest.TestCase):
    def smoothed(self, source, name, **values):
        done, target = serve(source, name, **values)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertTrue(target.exists(), done.stdout)
        return target

    def by_command_line(self, source, name, *options):
        target = work / f"{name}.ply"
        run_tool("smooth", source, target, "--quiet", *options)
        return target

    def test_same_vertices_as_the_command_line(self):
        ours = self.by_command_line(noisy, "defaults_tool")
        self.assertGreater(len(ply.positions(ours)), 33000)
        self.assertEqual(ply.positions(self.smoothed(noisy, "defaults_server")), ply.positions(ours))
        self.assertNotEqual(ply.positions(ours), ply.positions(noisy))

    def test_every_value_of_the_script_is_honoured(self):
        default = ply.positions(self.by_command_line(sheets, "sheets_tool"))
        for parameter, value, option in (("sigma_c", "1.3", "1.3"), ("sigma_s", "0.7", "0.7"),
                                         ("sigma_n", "0.13", "0.13"), ("rho", "1.3", "1.3"), ("iterations", "3", "3"),
                                         ("boundary", "1", "free")):
            with self.subTest(parameter):
                ours = ply.positions(self.by_command_line(sheets, f"{parameter}_tool",
                                                          "--" + parameter.replace("_", "-"), option))
                theirs = ply.positions(self.smoothed(sheets, f"{parameter}_server", **{parameter: value}))
                self.assertEqual(theirs, ours)
                self.assertNotEqual(theirs, default)

    def test_only_the_selection_moves(self):
        source = with_attributes(sheets, work / "selection.ply")
        before = ply.positions(source)
        everywhere = ply.positions(self.smoothed(source, "selection_off", selected="false"))
        after = ply.positions(self.smoothed(source, "selection_on", selected="true"))
        self.assertEqual(after, ply.positions(self.by_command_line(source, "selection_tool", "--selected")))
        selected = {i for i in range(len(before)) if i % 3 == 0}
        for i, corners in enumerate(ply.triangles(source)):
            if i % 5 == 0:
                selected.update(corners)
        self.assertLess(len(selected), len(before))
        for i, position in enumerate(after):
            if i in selected:  # as without selection, up to the rounding of another order of work
                for one, other in zip(ply.floats(position), ply.floats(everywhere[i])):
                    self.assertAlmostEqual(one, other, delta=1e-6)
            else:
                self.assertEqual(position, before[i], i)
        self.assertGreater(sum(a != b for a, b in zip(after, before)), len(selected) // 2)

    def test_attributes_stay_byte_for_byte(self):
        source = with_attributes(noisy, work / "attributed.ply")
        done, copy = serve(source, "attributed_copy", scripts.MEASURES, save=ATTRIBUTES)
        self.assertEqual(done.returncode, 0, done.stdout)
        done, result = serve(source, "attributed_result", save=ATTRIBUTES)
        self.assertEqual(done.returncode, 0, done.stdout)
        before, after = ply.read(copy), ply.read(result)
        self.assertLessEqual({"flags", "red", "quality", "texture_u"}, set(before["vertex"]))
        self.assertLessEqual({"flags", "red", "quality", "texcoord"}, set(before["face"]))
        self.assertNotEqual(before["vertex"]["x"], after["vertex"]["x"])
        self.assertEqual({e: list(p) for e, p in before.items()}, {e: list(p) for e, p in after.items()})
        for element, properties in before.items():
            for name, column in properties.items():
                if name not in ("x", "y", "z", "nx", "ny", "nz"):
                    self.assertEqual(column, after[element][name], f"{element} {name}")

    def test_log_tells_lengths_and_counts(self):
        report = work / "report.json"
        self.by_command_line(sheets, "report_tool", "--report", report)
        figures = json.loads(report.read_text())
        done, _ = serve(sheets, "report_server")
        for name in ("average_edge_length", "sigma_c_length", "sigma_s_length", "rho_length", "max_displacement",
                     "rms_displacement", "volume_before", "volume_after"):
            self.assertIn(f"{figures[name]:.6g}", done.stdout, name)
        self.assertIn(f"moved {figures['moved_vertices']} of {figures['vertices']} vertices", done.stdout)
        self.assertIn(f"held fixed {figures['fixed_vertices']}", done.stdout)

    def test_result_that_is_not_to_be_trusted_is_warned_about(self):
        source = work / "coarse.ply"
        corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2),
                 (2, 4, 6), (1, 3, 5), (3, 7, 5)]
        ply.write(source, [("vertex", [("x", "float"), ("y", "float"), ("z", "float")], corners),
                           ("face", [("vertex_indices", ("uchar", "int"))], [(face,) for face in faces])])
        report = work / "coarse.json"
        self.by_command_line(source, "coarse_tool", "--report", report)
        (warning,) = json.loads(report.read_text())["warnings"]
        self.assertIn("the enclosed volume changed from 1 to 1.38, by 37.7 %", warning)
        done, _ = serve(source, "coarse_result")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn(f"Warning: {warning}", done.stdout)
        self.assertIn("0 of 12 faces turned over", done.stdout)

    def test_unmerged_mesh_comes_out_as_the_merged_one(self):
        vertex = ply.read(sheets)["vertex"]
        points = list(zip(*(ply.floats(vertex[name]) for name in "xyz")))
        corners = [points[corner] for triangle in ply.triangles(sheets) for corner in triangle]
        source = work / "unmerged.ply"
        ply.write(source, [("vertex", [("x", "float"), ("y", "float"), ("z", "float")], corners),
                           ("face", [("vertex_indices", ("uchar", "int"))],
                            [([i, i + 1, i + 2],) for i in range(0, len(corners), 3)])])
        done, target = serve(source, "unmerged_result")
        self.assertEqual(done.returncode, 0, done.stdout)
        merged = ply.positions(self.by_command_line(sheets, "merged_tool"))
        self.assertEqual(ply.positions(target), [merged[corner] for triangle in ply.triangles(sheets)
                                                 for corner in triangle])


class DecimalComma(unittest.TestCase):
    """A user's locale in which numbers have a comma."""

    def test_texts_and_results_are_the_same(self):
        german = decimal_comma.environment(work / "locale")
        # MeshLab 2020.09 stops at an OBJ file in which a face refers to the first vertex.
        for kind in ("off", "ply", *(["obj"] if APPLY_MLX else [])):
            with self.subTest(kind):
                source, target = work / f"comma.{kind}", work / f"comma_result.{kind}"
                run_tool("noise", sheets, source, "--level", "0")
                script = scripts.write(work / "comma.mlx", scripts.SMOOTHING, sigma_c="1.25", sigma_n="0.125")
                results = []
                for locale in (meshlab.locale, german):
                    with meshlab.in_locale(locale):
                        done = meshlab.apply(display.name, script, source, target)
                    self.assertEqual(done.returncode, 0, done.stdout)
                    self.assertRegex(done.stdout, r"average edge length \d+\.\d+")
                    results.append(target.read_bytes())
                    target.unlink()
                self.assertEqual(results[0], results[1])
                if kind != "ply":
                    self.assertGreater(results[0].count(b"0."), 100)
                    self.assertNotIn(b"0,", results[0])


class ComparedFilters(unittest.TestCase):
    """The filters that the paper compares itself with, where MeshLab lacks them."""

    def same_as_the_command_line(self, filter_name, method, source, **values):
        options = [word for name, value in values.items()
                   for word in ("--" + name.replace("_", "-"), "free" if name == "boundary" else value)]
        name = "_".join([method, source.stem, *values])
        ours = work / f"{name}_tool.ply"
        run_tool("smooth", source, ours, "--quiet", "--method", method, *options)
        done, theirs = serve(source, f"{name}_server", filter_name, **values)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(ply.positions(theirs), ply.positions(ours))
        return ply.positions(ours)

    def test_same_vertices_as_the_command_line(self):
        for filter_name, method, values in (
                (scripts.BILATERAL, "bmd", {"sigma_c": "1.3", "sigma_s": "0.7", "iterations": "3", "boundary": "1"}),
                (scripts.NON_ITERATIVE, "jones", {"sigma_c": "1.3", "sigma_s": "0.7", "boundary": "1"}),
                (scripts.GUIDED, "guided", {"strength": "0.5", "feature_angle": "50", "iterations": "3"})):
            with self.subTest(filter_name):
                smoothed = self.same_as_the_command_line(filter_name, method, noisy)
                self.assertNotEqual(smoothed, ply.positions(noisy))
            default = self.same_as_the_command_line(filter_name, method, sheets)
            for name, value in values.items():
                with self.subTest(filter_name, parameter=name):
                    self.assertNotEqual(self.same_as_the_command_line(filter_name, method, sheets, **{name: value}),
                                        default)

    def test_bad_values(self):
        for number, (filter_name, name) in enumerate(((scripts.BILATERAL, "iterations"), (scripts.BILATERAL, "sigma_s"),
                                                      (scripts.NON_ITERATIVE, "sigma_c"))):
            with self.subTest(filter_name, parameter=name):
                done, target = serve(sheets, f"bad_compared_{number}", filter_name, **{name: "0"})
                self.assertEqual(done.returncode, meshlab.failure_status, done.stdout)
                self.assertFalse(target.exists())
                self.assertIn(f"{name} is 0; it must be", done.stdout)


class Geodesic(unittest.TestCase):
    def test_same_distances_and_colours_as_the_command_line(self):
        ours = work / "geodesic_tool.ply"
        run_tool("geodesic", noisy, ours, "--start-vertex", "1234", "--isolines", "7")
        done, theirs = serve(noisy, "geodesic_server", scripts.GEODESIC, ("-m", "vc", "vq"), start_vertex=1234,
                             isolines=7)
        self.assertEqual(done.returncode, 0, done.stdout)
        expected, result = ply.read(ours)["vertex"], ply.read(theirs)["vertex"]
        self.assertEqual(result["x"], ply.read(noisy)["vertex"]["x"])
        for channel in ("red", "green", "blue"):
            self.assertEqual(result[channel], expected[channel])
        self.assertEqual(result["quality"], [self.as_float(value) for value in expected["quality"]])
        self.assertEqual(ply.floats(result["quality"])[1234], 0)

    def as_float(self, raw):
        """The tool may write doubles; MeshLab's quality is a float."""
        return raw if len(raw) == 4 else struct.pack("<f", struct.unpack("<d", raw)[0])

    def test_unreachable_vertices_are_finite_grey_and_reported(self):
        done, target = serve(sheets, "unreachable", scripts.GEODESIC, ("-m", "vc", "vq"))
        self.assertEqual(done.returncode, 0, done.stdout)
        vertex = ply.read(target)["vertex"]
        quality = ply.floats(vertex["quality"])
        unreachable = [i for i, value in enumerate(quality) if value == -1]
        self.assertEqual(len(unreachable), len(quality) * 3 // 4)  # three of four sheets
        self.assertIn(f"{len(unreachable)} vertices are not connected", done.stdout)
        self.assertTrue(all(value >= 0 for i, value in enumerate(quality) if i not in set(unreachable)))
        for i in unreachable:
            self.assertEqual([vertex[c][i] for c in ("red", "green", "blue")], [b"\x80"] * 3)


class Failures(unittest.TestCase):
    """A line that tells what is wrong, no output."""

    def fails(self, done, target, *words):
        self.assertEqual(done.returncode, meshlab.failure_status, done.stdout)
        self.assertFalse(target.exists())
        errors = meshlab.errors(done)
        self.assertEqual(len(errors), 1, done.stdout)
        for word in words:
            self.assertIn(word.lower(), errors[0].lower())

    @unittest.skipIf(APPLY_MLX, "apply_mlx does not start without a mesh")
    def test_no_mesh(self):
        for name, kind in (("no_mesh", scripts.SMOOTHING), ("no_mesh_geodesic", scripts.GEODESIC)):
            self.fails(*serve(None, name, kind), "no mesh")

    def test_no_faces(self):
        points = work / "points.ply"
        ply.write(points, [("vertex", [("x", "float"), ("y", "float"), ("z", "float")],
                            [(i, i * i, 0) for i in range(10)])])
        for name, kind in (("no_faces", scripts.SMOOTHING), ("no_faces_geodesic", scripts.GEODESIC)):
            self.fails(*serve(points, name, kind), "face")

    def test_bad_values(self):
        cases = [(parameter, value, shown) for parameter in ("sigma_c", "sigma_s", "sigma_n", "rho")
                 for value, shown in (("0", "0"), ("-1.5", "-1.5"), ("nan", "nan"), ("inf", "inf"))]
        cases += [("iterations", "0", "0"), ("iterations", "-3", "-3"), ("boundary", "2", "2"), ("boundary", "-1", "-1")]
        for number, (parameter, value, shown) in enumerate(cases):
            with self.subTest(f"{parameter}={value}"):
                self.fails(*serve(sheets, f"bad_{number}", **{parameter: value}), parameter, f"is {shown};", "must be")

    def test_bad_values_of_the_geodesic_filter(self):
        count = len(ply.positions(sheets))
        for number, (parameter, value) in enumerate((("start_vertex", -1), ("start_vertex", count), ("isolines", -1))):
            with self.subTest(f"{parameter}={value}"):
                self.fails(*serve(sheets, f"bad_geodesic_{number}", scripts.GEODESIC, **{parameter: value}), parameter,
                           f"is {value};", "must be")

    def test_coordinate_that_is_not_finite(self):
        source = work / "nan.ply"
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (float("nan"), 1, 1)]
        ply.write(source, [("vertex", [("x", "float"), ("y", "float"), ("z", "float")], corners),
                           ("face", [("vertex_indices", ("uchar", "int"))], [([0, 1, 2],), ([1, 3, 2],)])])
        done, target = serve(source, "nan_result")
        if meshlab.cleans_what_it_opens:
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertEqual(len(ply.positions(target)), 3)
        else:
            self.fails(done, target, "finite", "3")

    def test_existing_output_is_kept(self):
        script = scripts.write(work / "kept.mlx", scripts.SMOOTHING, rho=-1)
        target = work / "kept.ply"
        target.write_text("precious")
        done = meshlab.apply(display.name, script, sheets, target)
        self.assertEqual(done.returncode, meshlab.failure_status)
        self.assertEqual(target.read_text(), "precious")


@unittest.skipIf(APPLY_MLX, "meshlabserver lists filters; since 2021 MeshLab has none")
class Menu(unittest.TestCase):
    def test_filters_are_listed_with_their_help(self):
        listing = work / "filters.txt"
        meshlab.server(display.name, "-d", listing)
        text = listing.read_text(errors="replace")
        for name in (scripts.SMOOTHING, scripts.GEODESIC, scripts.BILATERAL, scripts.NON_ITERATIVE):
            self.assertIn(name, text)
        self.assertIn("Anisotropic Feature-Preserving Smoothing of 3D Mesh", text)


if __name__ == "__main__":
    unittest.main()
