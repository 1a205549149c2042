# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line from end to end: exit statuses, messages, files."""

import json
import math
import os
import pty
import signal
import stat
import struct
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))

import decimal_comma  # noqa: E402
from command_line import FORMATS, PROGRAM, CommandLine  # noqa: E402


def read_ply(path):
    """Vertex rows as dicts and the raw data behind them of a PLY file that begins with its vertices, none of which has a list."""
    with open(path, "rb") as file:
        data = file.read()
    head, body = data.split(b"end_header\n", 1)
    is_text = b"format ascii" in head
    formats = {"float": "f", "double": "d", "int": "i", "uchar": "B"}
    count, names, layout, in_vertex = 0, [], "<", False
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            in_vertex = words[1] == "vertex"
            count = int(words[2]) if in_vertex else count
        elif words[0] == "property" and in_vertex:
            names.append(words[2])
            layout += formats[words[1]]
    if is_text:
        lines = body.split(b"\n")
        rows = [dict(zip(names, map(float, line.split()))) for line in lines[:count]]
        return head, rows, b"\n".join(lines[count:])
    size = struct.calcsize(layout)
    rows = [dict(zip(names, struct.unpack_from(layout, body, i * size))) for i in range(count)]
    return head, rows, body[count * size:]


class Subcommands(CommandLine):
    # what works

    def test_smoothing_brings_the_mesh_nearer_to_the_truth(self):
        self.noisy()
        self.run_tool("smooth", "noisy.ply", "smooth.ply")
        figures = {}
        for name in ("noisy", "smooth"):
            output = self.run_tool("measure", f"{name}.ply", "clean.ply", "--noisy", "noisy.ply", "--json").stdout
            figures[name] = json.loads(output)
        for key, part in (("normal_error_mean", 0.7), ("sharp_normal_error_mean", 0.7), ("distance_rms", 0.7),
                          ("reverse_distance_rms", 0.9)):
            self.assertLess(figures["smooth"][key], part * figures["noisy"][key], key)
        self.assertLess(figures["smooth"]["tangential_drift"], 1e-3, "vertices move along their normals")
        self.assertEqual(sorted(os.listdir(self.folder)), ["clean.ply", "noisy.ply", "smooth.ply"])

    def test_report(self):
        self.noisy()
        self.run_tool("smooth", "noisy.ply", "smooth.ply", "--sigma-c", "3", "--rho", "1.5", "--report", "report.json")
        report = json.loads(self.bytes_of("report.json"))
        self.assertEqual(report["method"], "paper")
        self.assertEqual(report["parameters"]["sigma_c"], 3)
        self.assertEqual(report["parameters"]["boundary"], "fixed")
        e = report["average_edge_length"]
        self.assertAlmostEqual(report["sigma_c_length"] / e, 3)
        self.assertAlmostEqual(report["rho_length"] / e, 4.5)
        _, before, _ = read_ply(self.path("noisy.ply"))
        _, after, _ = read_ply(self.path("smooth.ply"))
        moves = [math.dist([a[k] for k in "xyz"], [b[k] for k in "xyz"]) for a, b in zip(before, after)]
        self.assertEqual(report["vertices"], len(moves))
        self.assertEqual(report["moved_vertices"], sum(move > 0 for move in moves))
        self.assertAlmostEqual(report["max_displacement"], max(moves), delta=1e-6)
        self.assertEqual(report["skipped_vertices"], {"isolated": 0, "undefined_normal": 0, "empty_neighbourhood": 0})
        for key in ("fixed_vertices", "rms_displacement", "volume_before", "volume_after", "sigma_s_length"):
            self.assertIn(key, report)

    def test_report_of_a_coarse_cube(self):
        """The paper's filter blows it up, and says so: on stderr, also when it is to be quiet, and in the report."""
        with open(self.path("cube.off"), "w", encoding="utf-8") as file:
            file.write("OFF\n8 12 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
                       "3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n3 2 6 3\n3 3 6 7\n3 0 4 2\n3 2 4 6\n"
                       "3 1 3 5\n3 3 7 5\n")
        done = self.run_tool("smooth", "cube.off", "big.off", "--quiet", "--report", "report.json")
        report = json.loads(self.bytes_of("report.json"))
        self.assertAlmostEqual(report["volume_after"], 1.377, delta=0.001)
        self.assertEqual((report["faces"], report["flipped_faces"], report["bounded_vertices"]), (12, 0, 0))
        self.assertIs(report["closed"], True)
        self.assertNotIn("self_intersections", report)
        (warning,) = report["warnings"]
        self.assertIn("volume changed from 1 to 1.38, by 37.7 %", warning)
        self.assertIn("use the guided filter", warning)
        self.assertEqual(done.stderr, f"warning: {warning}\n")

    def test_check_counts_self_intersections(self):
        peak = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), (.4, .4, -1), (.7, .4, -1), (.4, .7, -1), (.5, .5, .5)]
        sides = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
        with open(self.path("peak.off"), "w", encoding="utf-8") as file:
            file.write("OFF\n8 8 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in peak) +
                       "".join(f"3 {a + first} {b + first} {c + first}\n" for first in (0, 4) for a, b, c in sides))
        figures = json.loads(self.run_tool("measure", "peak.off", "peak.off", "--check", "--json").stdout)
        self.assertEqual(figures["self_intersections"], 4)
        self.assertIn("faces that cut through others", self.run_tool("measure", "peak.off", "peak.off", "--check").stdout)
        self.assertNotIn("self_intersections", self.run_tool("measure", "peak.off", "peak.off", "--json").stdout)
        self.run_tool("smooth", "peak.off", "x.ply", "--check", "--report", "report.json", "--sigma-s", "0.001")
        report = json.loads(self.bytes_of("report.json"))
        again = json.loads(self.run_tool("measure", "x.ply", "peak.off", "--check", "--json").stdout)
        self.assertEqual(report["self_intersections"], again["self_intersections"])
        self.assertEqual(report["self_intersections"], 4)
        self.assertTrue(any("4 faces of the result cut through" in warning for warning in report["warnings"]))

    def test_every_method_of_the_help_runs(self):
        self.noisy("cube", "400")
        self.run_tool("smooth", "--help")
        bad = self.run_tool("smooth", "noisy.ply", "x.ply", "--method", "none", status=1).stderr
        methods = bad.split("allowed are ")[1].strip().split(", ")
        self.assertIn("paper", methods)
        results = set()
        for method in methods:
            self.run_tool("smooth", "noisy.ply", "x.ply", "--method", method, "--quiet")
            results.add(self.bytes_of("x.ply"))
        self.assertEqual(len(results), len(methods), "all methods differ")

    def test_printed_gaussian_threads_and_boundary_have_their_effect(self):
        self.noisy("plane_delaunay", "1000")
        def smooth(*options):
            self.run_tool("smooth", "noisy.ply", "x.ply", "--quiet", *options)
            return self.bytes_of("x.ply")
        plain = smooth()
        self.assertEqual(smooth("--threads", "3"), plain)
        self.assertEqual(smooth("--gaussian", "standard_deviation", "--boundary", "fixed"), plain)
        self.assertNotEqual(smooth("--gaussian", "printed"), plain)
        self.assertNotEqual(smooth("--boundary", "free"), plain)
        self.assertNotEqual(smooth("--iterations", "2"), plain)

    def test_result_may_replace_the_input(self):
        self.noisy()
        self.run_tool("smooth", "noisy.ply", "other.ply")
        self.run_tool("smooth", "noisy.ply", "noisy.ply")
        self.assertEqual(self.bytes_of("noisy.ply"), self.bytes_of("other.ply"))

    def test_precision_of_the_input_is_kept(self):
        for options, kind in (([], b"property float x"), (["--double"], b"property double x")):
            self.noisy("cube", "400", *options)
            self.assertIn(kind, self.bytes_of("clean.ply"))
            self.run_tool("smooth", "noisy.ply", "smooth.ply")
            self.assertIn(kind, self.bytes_of("smooth.ply"))

    def test_formats_convert_and_agree(self):
        self.noisy("cube", "400", "--double")
        self.run_tool("smooth", "noisy.ply", "smooth.ply")
        for kind in ("obj", "off"):
            self.run_tool("noise", "noisy.ply", f"noisy.{kind}", "--level", "0")
            self.run_tool("smooth", f"noisy.{kind}", f"smooth_{kind}.ply")
            self.assertEqual(self.bytes_of(f"smooth_{kind}.ply"), self.bytes_of("smooth.ply"), kind)
        self.run_tool("noise", "noisy.ply", "noisy.stl", "--level", "0")
        self.run_tool("smooth", "noisy.stl", "smooth.stl")
        self.assertGreater(os.path.getsize(self.path("smooth.stl")), 84)

    def test_a_locale_with_a_decimal_comma_changes_nothing(self):
        self.noisy("cube", "400")
        german = decimal_comma.environment(self.path("locale"))
        printed = {}
        for name, environment in (("c", {"LC_ALL": "C.UTF-8"}), ("german", german)):
            os.mkdir(self.path(name))
            printed[name] = []
            for kind in FORMATS:
                commands = (("noise", "noisy.ply", f"{name}/noisy.{kind}", "--level", "0.1"),
                            ("smooth", f"{name}/noisy.{kind}", f"{name}/smooth.{kind}", "--sigma-n", "0.25", "--report",
                             f"{name}/{kind}.json"),
                            ("measure", f"{name}/noisy.{kind}", f"{name}/smooth.{kind}"))
                printed[name] += [self.run_tool(*command, environment=environment).stdout for command in commands]
        self.assertEqual([text.replace("german/", "c/") for text in printed["german"]], printed["c"])
        files = os.listdir(self.path("c"))
        self.assertEqual(len(files), 3 * len(FORMATS))
        for file in files:
            self.assertEqual(self.bytes_of(f"german/{file}"), self.bytes_of(f"c/{file}"), file)

    def test_an_output_that_is_a_link_is_written_to_its_target(self):
        self.noisy("cube", "400")
        os.mkdir(self.path("deep"))
        os.symlink("deep/mesh.ply", self.path("link.ply"))
        for _ in range(2):  # the target is not there at first
            self.run_tool("smooth", "noisy.ply", "link.ply", "--report", "link.json")
            self.assertTrue(stat.S_ISLNK(os.lstat(self.path("link.ply")).st_mode))
            self.assertFalse(os.path.islink(self.path("deep/mesh.ply")))
        self.run_tool("smooth", "noisy.ply", "plain.ply")
        self.assertEqual(self.bytes_of("deep/mesh.ply"), self.bytes_of("plain.ply"))
        os.symlink("none/mesh.ply", self.path("lost.ply"))
        self.expect_failure("smooth", "noisy.ply", "lost.ply", says=("lost.ply", "no folder", "none"))
        os.symlink("round.ply", self.path("round.ply"))
        self.expect_failure("smooth", "noisy.ply", "round.ply", says=("round.ply", "symbolic links"))

    def test_attributes_come_through_byte_for_byte(self):
        self.noisy("cube", "400")
        self.run_tool("geodesic", "noisy.ply", "colored.ply", "--start-vertex", "0")
        self.run_tool("smooth", "colored.ply", "smooth.ply")
        head, before, faces = read_ply(self.path("colored.ply"))
        new_head, after, new_faces = read_ply(self.path("smooth.ply"))
        self.assertEqual(head, new_head)
        self.assertEqual(faces, new_faces)
        for a, b in zip(before, after):
            self.assertEqual({**a, "x": 0, "y": 0, "z": 0}, {**b, "x": 0, "y": 0, "z": 0})

    def selection(self):
        """A plane of which the faces of the left half are selected."""
        n, selected_flag = 12, 0x20
        points = [(x / n, y / n, 0.01 * math.sin(37 * x + 91 * y)) for y in range(n + 1) for x in range(n + 1)]
        faces = []
        for y in range(n):
            for x in range(n):
                a = y * (n + 1) + x
                flags = selected_flag if x < n // 2 else 0
                faces += [(a, a + 1, a + n + 2, flags), (a, a + n + 2, a + n + 1, flags)]
        with open(self.path("selected.ply"), "w") as file:
            file.write("ply\nformat ascii 1.0\n"
                       f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
                       f"element face {len(faces)}\nproperty list uchar int vertex_indices\nproperty int flags\n"
                       "end_header\n")
            file.writelines("%r %r %r\n" % p for p in points)
            file.writelines("3 %d %d %d %d\n" % f for f in faces)
        return n, points

    def test_a_selection_in_the_file_is_obeyed_unless_told_otherwise(self):
        n, points = self.selection()
        def moved(*options):
            result = self.run_tool("smooth", "selected.ply", "x.ply", "--boundary", "free", *options)
            _, rows, _ = read_ply(self.path("x.ply"))
            def stored(value):
                return struct.unpack("f", struct.pack("f", value))[0]
            return result, [stored(row["z"]) != stored(p[2]) for row, p in zip(rows, points)]
        result, by_default = moved()
        self.assertIn("has a selection", result.stderr)
        expected = [x <= n // 2 for _ in range(n + 1) for x in range(n + 1)]
        for moves, may in zip(by_default, expected):
            self.assertLessEqual(moves, may)
        self.assertGreater(sum(by_default), 0.9 * sum(expected))
        self.assertEqual(moved("--selected")[1], by_default)
        self.assertGreater(sum(moved("--no-selected")[1]), 1.5 * sum(by_default))
        self.expect_failure("smooth", "selected.ply", "y.ply", "--selected", "--no-selected", says="help", status=2)

    def test_geodesic_writes_distance_and_colour(self):
        self.run_tool("generate", "plane_slash", "plane.ply", "--vertices", "400", "--double")
        self.run_tool("geodesic", "plane.ply", "out.ply", "--start-vertex", "0", "--isolines", "5")
        _, rows, _ = read_ply(self.path("out.ply"))
        for row in rows:
            self.assertAlmostEqual(row["quality"], math.hypot(row["x"], row["y"]), delta=1e-14)
        colors = {(row["red"], row["green"], row["blue"]) for row in rows}
        self.assertGreater(len(colors), 20)
        self.run_tool("geodesic", "plane.ply", "plain.ply", "--start-vertex", "0", "--isolines", "0")
        self.assertNotEqual(self.bytes_of("plain.ply"), self.bytes_of("out.ply"))

    def test_noise_is_the_same_for_the_same_seed(self):
        self.noisy()
        first = self.bytes_of("noisy.ply")
        self.run_tool("noise", "clean.ply", "again.ply", "--level", "0.2", "--seed", "3")
        self.assertEqual(self.bytes_of("again.ply"), first)
        self.run_tool("noise", "clean.ply", "other.ply", "--level", "0.2", "--seed", "4")
        self.assertNotEqual(self.bytes_of("other.ply"), first)
        self.run_tool("noise", "clean.ply", "any.ply", "--level", "0.2", "--seed", "3", "--direction", "any")
        self.assertNotEqual(self.bytes_of("any.ply"), first)

    def test_noise_has_other_kinds(self):
        self.noisy()
        seen = {self.bytes_of("noisy.ply")}
        for options in (("--correlation", "2"), ("--share", "0.3"), ("--level-far", "0.4"), ("--camera", "0,0,9"),
                        ("--step", "0.5"), ("--step", "0.5", "--axis", "1,2,3"), ("--camera=-1,0,9", "--share", "0.9")):
            self.run_tool("noise", "clean.ply", "other.ply", "--level", "0.2", "--seed", "3", *options)
            self.assertNotIn(self.bytes_of("other.ply"), seen, options)
            seen.add(self.bytes_of("other.ply"))

    def test_voxel_shapes_come_with_their_truth(self):
        self.run_tool("generate", "voxel_sphere", "voxels.ply", "--vertices", "3000", "--truth", "truth.ply")
        figures = json.loads(self.run_tool("measure", "voxels.ply", "truth.ply", "--json").stdout)
        self.assertAlmostEqual(figures["normal_error_mean"], 20.6, delta=0.7)
        for row in read_ply(self.path("truth.ply"))[1]:
            self.assertAlmostEqual(math.hypot(row["x"], row["y"], row["z"]), 1, delta=1e-6)
        cubic = self.bytes_of("voxels.ply")
        for options in (("--slice-distance", "3"), ("--tilt", "20")):
            self.run_tool("generate", "voxel_sphere", "voxels.ply", "--vertices", "3000", *options)
            self.assertNotEqual(self.bytes_of("voxels.ply"), cubic)

    def test_measure_prints_a_table_for_people(self):
        self.noisy("cube", "400")
        output = self.run_tool("measure", "noisy.ply", "clean.ply", "--noisy", "noisy.ply").stdout
        for text in ("face normal error", "at sharp edges", "volume change", "flipped faces", "tangential drift"):
            self.assertIn(text, output)

    def test_measure_of_planes_has_no_volume(self):
        self.run_tool("generate", "plane_slash", "plane.ply", "--vertices", "100")
        figures = json.loads(self.run_tool("measure", "plane.ply", "plane.ply", "--json").stdout)
        self.assertIsNone(figures["volume_change_percent"])
        self.assertNotIn("tangential_drift", figures)

    def test_quiet_prints_nothing(self):
        self.noisy("cube", "400")
        for arguments in (["smooth", "noisy.ply", "x.ply"], ["geodesic", "noisy.ply", "x.ply", "--start-vertex", "1"],
                          ["noise", "noisy.ply", "x.ply", "--level", "0.1"], ["generate", "cube", "x.ply"]):
            result = self.run_tool(*arguments, "--quiet")
            self.assertEqual(result.stdout + result.stderr, "", arguments)

    def test_warnings_go_to_stderr(self):
        self.noisy("cube", "400")
        result = self.run_tool("smooth", "noisy.ply", "x.ply", "--method", "laplacian", "--sigma-n", "0.1", "--quiet")
        self.assertIn("sigma_n has no effect with method laplacian", result.stderr)

    def test_help_and_version(self):
        self.assertIn("smooth", self.run_tool("--help").stdout)
        self.assertRegex(self.run_tool("--version").stdout, r"^\d+\.\d+\.\d+\n$")
        text = self.run_tool("generate", "--help").stdout
        for shape in ("plane_slash", "plane_delaunay", "sphere", "torus", "cube", "stepped_block", "cad_part",
                      "thin_plate", "thin_sheets", "graded_cube"):
            self.assertIn(shape, text)
            self.run_tool("generate", shape, "x.ply", "--vertices", "1000")

    # what fails

    def test_wrong_command_lines(self):
        self.noisy("cube", "400")
        for arguments in ([], ["polish"], ["smooth"], ["smooth", "noisy.ply"], ["smooth", "noisy.ply", "x.ply", "more"],
                          ["smooth", "noisy.ply", "x.ply", "--sigma-d", "1"],
                          ["smooth", "noisy.ply", "x.ply", "--sigma-c", "two"],
                          ["smooth", "noisy.ply", "x.ply", "--iterations", "1.5"],
                          ["smooth", "noisy.ply", "x.ply", "--sigma-c"], ["geodesic", "noisy.ply", "x.ply"],
                          ["noise", "noisy.ply", "x.ply"], ["measure", "noisy.ply"], ["generate", "cube"]):
            self.expect_failure(*arguments, says="help", status=2)

    def test_bad_parameters(self):
        self.noisy("cube", "400")
        smooth = ("smooth", "noisy.ply", "x.ply")
        for option in ("--sigma-c", "--sigma-s", "--sigma-n", "--rho"):
            for value in ("0", "-1", "nan", "inf"):
                name = option[2:].replace("-", "_")
                self.expect_failure(*smooth, option, value, says=(name + " is ", "greater than 0"))
        self.expect_failure(*smooth, "--iterations", "0", says=("iterations is 0", "1 or more"))
        self.expect_failure(*smooth, "--threads", "-1", says=("threads is -1", "0"))
        self.expect_failure(*smooth, "--method", "magic", says=("'magic'", "allowed are paper"))
        self.expect_failure(*smooth, "--boundary", "loose", says=("'loose'", "fixed and free"))
        self.expect_failure(*smooth, "--gaussian", "bell", says=("'bell'", "printed"))
        geodesic = ("geodesic", "noisy.ply", "x.ply", "--start-vertex")
        self.expect_failure(*geodesic, "-1", says=("start_vertex is -1", "allowed are 0 to"))
        self.expect_failure(*geodesic, "400000", says=("start_vertex is 400000", "allowed are 0 to"))
        self.expect_failure(*geodesic, "0", "--isolines", "-1", says=("isolines is -1", "0 or more"))
        self.expect_failure("geodesic", "noisy.ply", "x.obj", "--start-vertex", "0", says=".ply")
        self.expect_failure("noise", "noisy.ply", "x.ply", "--level", "-0.1", says=("level is -0.1", "0 or more"))
        self.expect_failure("noise", "noisy.ply", "x.ply", "--level", "0.1", "--direction", "up", says="'up'")
        for option, value in (("share", "0"), ("share", "2"), ("correlation", "-1"), ("step", "-1"), ("level-far", "-1"),
                              ("axis", "0,0,0"), ("camera", "inf,0,0")):
            self.expect_failure("noise", "noisy.ply", "x.ply", "--level", "0.1", f"--{option}={value}",
                                says=option.split("-")[0])
        self.expect_failure("noise", "noisy.ply", "x.ply", "--level", "0.1", "--camera", "0,0,9", "--direction", "any",
                            says="both given")
        self.expect_failure("generate", "voxel_pyramid", "x.ply", says=("'voxel_pyramid'", "voxel_stepped_block"))
        self.expect_failure("generate", "voxel_cube", "x.ply", "--slice-distance", "7", says=("7", "1 to 6"))
        self.expect_failure("generate", "voxel_cube", "x.ply", "--truth", "x.ply", says="same file")
        self.expect_failure("generate", "cube", "x.ply", "--truth", "y.ply", says="voxel shapes only")
        self.expect_failure("generate", "cube", "x.ply", "--slice-distance", "2", says="voxel shapes only")
        self.expect_failure("generate", "pyramid", "x.ply", says=("'pyramid'", "stepped_block"))
        self.expect_failure("generate", "cube", "x.ply", "--vertices", "0", says=("vertices is 0", "allowed are 1 to"))

    def test_bad_files(self):
        self.noisy("cube", "400")
        with open(self.path("points.ply"), "w") as file:
            file.write("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                       "end_header\n0 0 0\n")
        with open(self.path("nan.off"), "w") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n")
        with open(self.path("cut.ply"), "wb") as file:
            file.write(self.bytes_of("noisy.ply")[:-100])
        self.expect_failure("smooth", "none.ply", "x.ply", says=("none.ply", "does not exist"))
        self.expect_failure("smooth", "noisy.ply", "x.3ds", says=("x.3ds", "allowed are .ply"))
        self.expect_failure("smooth", "noisy.ply", "none/x.ply", says=("none/x.ply", "no folder"))
        self.expect_failure("smooth", "cut.ply", "x.ply", says=("cut.ply", "cut off"))
        self.expect_failure("smooth", "points.ply", "x.ply", says="no faces")
        self.expect_failure("smooth", "nan.off", "x.ply", says="finite")
        self.expect_failure("smooth", "noisy.ply", "x.ply", "--report", "none/r.json", says="none/r.json")
        self.expect_failure("smooth", "noisy.ply", "x.ply", "--report", "x.ply", says="another file")
        for report in ("./x.ply", "noisy.ply", "link.json"):  # the link leads to the output, which is not there yet
            if report == "link.json":
                os.symlink("x.ply", self.path(report))
            self.expect_failure("smooth", "noisy.ply", "x.ply", "--report", report, says="another file")
        for output in ("x.obj", "x.OBJ"):  # it belongs to the output, with materials or without
            for report in (f"{output}.mtl", f"./{output}.mtl"):
                self.expect_failure("smooth", "noisy.ply", output, "--report", report, says=(report, "materials"))
        self.run_tool("noise", "noisy.ply", "y.obj", "--level", "0")
        self.expect_failure("smooth", "y.obj", "x.ply", "--report", "y.obj.mtl", says="another file")
        self.expect_failure("measure", "noisy.ply", "points.ply", says="no faces")
        self.run_tool("generate", "cube", "other.ply", "--vertices", "500")
        self.expect_failure("measure", "noisy.ply", "other.ply", says="same connectivity")

    def test_an_existing_output_survives_failure(self):
        self.noisy("cube", "400")
        with open(self.path("x.ply"), "w") as file:
            file.write("precious")
        self.expect_failure("smooth", "noisy.ply", "x.ply", "--sigma-c", "-1", says="sigma_c")
        self.expect_failure("smooth", "none.ply", "x.ply", says="none.ply")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_protected_places(self):
        self.noisy("cube", "400")
        os.mkdir(self.path("locked"))
        os.chmod(self.path("locked"), 0o500)
        self.addCleanup(os.chmod, self.path("locked"), 0o700)
        self.run_tool("smooth", "noisy.ply", "locked/x.ply", status=1)

    def glb(self, name, mesh):
        """A GLB file with the vertices and triangles of an OFF file."""
        _, counts, *lines = self.bytes_of(mesh).decode().splitlines()
        vertices = int(counts.split()[0])
        points = [[float(word) for word in line.split()] for line in lines[:vertices]]
        corners = [int(word) for line in lines[vertices:] for word in line.split()[1:]]
        data = b"".join(struct.pack("<3f", *point) for point in points) + struct.pack(f"<{len(corners)}I", *corners)
        text = json.dumps({
            "asset": {"version": "2.0"}, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": vertices, "type": "VEC3",
                           "min": [min(axis) for axis in zip(*points)], "max": [max(axis) for axis in zip(*points)]},
                          {"bufferView": 1, "componentType": 5125, "count": len(corners), "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteLength": 12 * vertices},
                            {"buffer": 0, "byteOffset": 12 * vertices, "byteLength": 4 * len(corners)}],
            "buffers": [{"byteLength": len(data)}]}).encode()
        text += b" " * (-len(text) % 4)
        with open(self.path(name), "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") +
                       text + struct.pack("<I4s", len(data), b"BIN\0") + data)

    def test_glb_gives_the_vertices_that_ply_gives(self):
        self.noisy("cube", "500")
        self.run_tool("noise", "noisy.ply", "noisy.off", "--level", "0", "--quiet")
        self.glb("noisy.glb", "noisy.off")
        for method in ("paper", "guided"):
            self.run_tool("smooth", "noisy.ply", "a.ply", "--method", method, "--quiet")
            self.run_tool("smooth", "noisy.glb", "a.glb", "--method", method, "--quiet")
            self.run_tool("noise", "a.ply", "expected.off", "--level", "0", "--quiet")
            self.run_tool("noise", "a.glb", "found.off", "--level", "0", "--quiet")
            self.assertEqual(self.bytes_of("found.off"), self.bytes_of("expected.off"))
            self.assertEqual(len(self.bytes_of("a.glb")) % 4, 0)
        for arguments in (("generate", "cube", "x.glb"), ("smooth", "noisy.ply", "x.glb"),
                          ("noise", "noisy.glb", "x.gltf", "--level", "0.1")):
            self.expect_failure(*arguments, says="is only written as a copy of one that was read")

    def test_vertices_of_no_face_may_be_nowhere(self):
        self.run_tool("generate", "cube", "a.off", "--vertices", "200", "--quiet")
        word, counts, *lines = self.bytes_of("a.off").decode().splitlines()
        vertices, faces, _ = map(int, counts.split())
        for at in (0, vertices):  # before all others, and behind them
            rows = [" ".join(["3", *(str(int(v) + (at == 0)) for v in line.split()[1:])]) for line in lines[vertices:]]
            points = lines[:at] + ["nan 0 -inf"] + lines[at:vertices]
            with open(self.path("nan.off"), "w", encoding="ascii") as file:
                file.write("\n".join([word, f"{vertices + 1} {faces} 0", *points, *rows]) + "\n")
            done = self.run_tool("smooth", "nan.off", "out.off", "--method", "taubin", "--quiet")
            self.assertIn("nan.off: 1 vertex that no face uses has coordinates that are not finite", done.stderr)
            self.run_tool("smooth", "a.off", "expected.off", "--method", "taubin", "--quiet")
            found = self.bytes_of("out.off").decode().splitlines()[2:]
            self.assertEqual(found.pop(at), "nan 0 -inf")
            self.assertEqual(found[:vertices], self.bytes_of("expected.off").decode().splitlines()[2:vertices + 2])

    # interruption and progress

    def interrupt(self, number, delay):
        process = subprocess.Popen([PROGRAM, "smooth", "noisy.ply", "x.ply", "--sigma-c", "8", "--iterations", "50"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
        time.sleep(delay)
        process.send_signal(number)
        start = time.monotonic()
        output = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 130, output)
        return time.monotonic() - start

    def test_interruption(self):
        self.noisy("cad_part", "20000")
        with open(self.path("x.ply"), "w") as file:
            file.write("precious")
        before = sorted(os.listdir(self.folder))
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            self.assertLess(self.interrupt(number, 1.0), 5)
            self.assertEqual(self.bytes_of("x.ply"), b"precious")
            self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_who_was_started_to_outlive_the_terminal_does(self):
        self.noisy("cad_part", "20000")
        process = subprocess.Popen([PROGRAM, "smooth", "noisy.ply", "x.ply", "--sigma-c", "4"], cwd=self.folder,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))  # as nohup does
        while process.poll() is None:
            process.send_signal(signal.SIGHUP)
            time.sleep(0.05)
        self.assertEqual(process.returncode, 0)
        self.assertTrue(os.path.exists(self.path("x.ply")))

    def test_progress_is_a_bar_on_a_terminal_only(self):
        self.noisy("cad_part", "20000")
        arguments = [PROGRAM, "smooth", "noisy.ply", "x.ply", "--sigma-c", "6", "--iterations", "8", "--threads", "1"]
        leader, follower = pty.openpty()
        process = subprocess.Popen(arguments, cwd=self.folder, stdout=subprocess.PIPE, stderr=follower)
        os.close(follower)
        seen = b""
        while b"%" not in seen:
            try:
                seen += os.read(leader, 4096)
            except OSError:
                break
        process.send_signal(signal.SIGINT)
        while True:
            try:
                if not os.read(leader, 4096):
                    break
            except OSError:
                break
        process.communicate(timeout=30)
        os.close(leader)
        self.assertRegex(seen.decode(), r"\[#*\.*\] +\d+ %")
        self.assertEqual(self.run_tool("smooth", "noisy.ply", "x.ply").stderr, "")


if __name__ == "__main__":
    unittest.main()
