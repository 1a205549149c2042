"""What apply_mlx promises besides what test_scripts.py asks of every MeshLab: defaults for what a script leaves out,
several filters in their order, MeshLab's own filters and formats, and one clear line and nothing written when something
is wrong."""

import os
import pathlib
import re
import subprocess
import unittest

import ply
import scripts
from environment import APPLY_MLX, PLUGIN, SOURCE, fresh_work_folder, make_meshlab, run_tool


def setUpModule():
    global work, meshlab, noisy
    work = fresh_work_folder()
    meshlab = make_meshlab(work)
    noisy = work / "noisy.ply"
    run_tool("generate", "cad_part", work / "clean.ply", "--vertices", 2000)
    run_tool("noise", work / "clean.ply", noisy, "--level", "0.2")


def write_script(name, *filters):
    """`filters` is a list of (name, [attributes of a Param])."""
    lines = ["<!DOCTYPE FilterScript>", "<FilterScript>"]
    for filter_name, parameters in filters:
        lines.append(f' <filter name="{filter_name}">')
        lines += [f"  <Param {attributes}/>" for attributes in parameters]
        lines.append(" </filter>")
    path = work / f"{name}.mlx"
    path.write_text("\n".join([*lines, "</FilterScript>", ""]))
    return path


def number(name, value, kind="RichFloat"):
    return f'type="{kind}" name="{name}" value="{value}"'


def smoothed_by_tool(source, name, *options):
    target = work / f"{name}_tool.ply"
    run_tool("smooth", source, target, "--quiet", *options)
    return target


class Done(unittest.TestCase):
    def applied(self, script, source=None, target=None):
        target = target or work / f"{script.stem}.ply"
        done = meshlab.apply(None, script, source or noisy, target)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertTrue(target.exists())
        return target, done.stdout

    def test_what_a_script_leaves_out_has_its_default(self):
        for name, parameters, options in (("nothing", [], []),
                                          ("one", [number("sigma_n", "0.2")], ["--sigma-n", "0.2"])):
            with self.subTest(name):
                target, _ = self.applied(write_script(f"partial_{name}", (scripts.SMOOTHING, parameters)))
                self.assertEqual(ply.positions(target), ply.positions(smoothed_by_tool(noisy, f"partial_{name}", *options)))

    def test_filters_run_in_their_order(self):
        first = (scripts.SMOOTHING, [number("sigma_s", "0.5")])
        second = (scripts.BILATERAL, [number("sigma_c", "1.3")])
        target, printed = self.applied(write_script("in_order", first, second))
        halfway = smoothed_by_tool(noisy, "halfway", "--sigma-s", "0.5")
        expected = smoothed_by_tool(halfway, "in_order", "--method", "bmd", "--sigma-c", "1.3")
        self.assertEqual(ply.positions(target), ply.positions(expected))
        self.assertLess(printed.index(scripts.SMOOTHING), printed.index(scripts.BILATERAL))
        reverse, _ = self.applied(write_script("in_reverse", second, first))
        self.assertNotEqual(ply.positions(reverse), ply.positions(expected))

    def test_filters_of_meshlab_and_of_the_plugin_mix(self):
        smooth = (scripts.SMOOTHING, [])
        target, _ = self.applied(write_script("mixed", ("Invert Faces Orientation", []), smooth, (scripts.MEASURES, [])))
        alone, printed = self.applied(write_script("inverted", ("Invert Faces Orientation", [])))
        self.assertIn("Invert Faces Orientation", printed)
        self.assertEqual(ply.triangles(target), ply.triangles(alone))
        self.assertNotEqual(ply.triangles(alone), ply.triangles(noisy))
        self.assertEqual(ply.positions(target), ply.positions(smoothed_by_tool(alone, "mixed")))

    def test_values_of_several_attributes(self):
        color = ('type="RichColor" name="color1" r="10" g="20" b="30" a="255"', number("onSelected", "false", "RichBool"))
        target, _ = self.applied(write_script("filled", ("Vertex Color Filling", color)))
        vertex = ply.read(target)["vertex"]
        self.assertEqual({(vertex["red"][i], vertex["green"][i], vertex["blue"][i]) for i in range(len(vertex["x"]))},
                         {(b"\x0a", b"\x14", b"\x1e")})

    def test_log_of_the_filters_is_printed(self):
        _, printed = self.applied(write_script("logged", (scripts.SMOOTHING, [])))
        self.assertRegex(printed, r"moved \d+ of \d+ vertices")
        self.assertNotIn("LOG:", printed)

    def test_other_formats(self):
        script = write_script("formats", (scripts.SMOOTHING, []))
        for kind in ("obj", "off", "stl"):
            with self.subTest(kind):
                self.applied(script, target=work / f"format.{kind}")
                back, _ = self.applied(write_script("read_back", (scripts.MEASURES, [])), work / f"format.{kind}",
                                       work / f"format_{kind}.ply")
                self.assertEqual(len(ply.positions(back)), len(ply.positions(noisy)))

    def test_the_input_may_be_the_output(self):
        target = work / "in_place.ply"
        target.write_bytes(noisy.read_bytes())
        self.applied(write_script("in_place", (scripts.SMOOTHING, [])), target, target)
        self.assertEqual(ply.positions(target), ply.positions(smoothed_by_tool(noisy, "in_place")))

    def test_a_link_stays_a_link_and_permissions_stay(self):
        real, link = work / "real.ply", work / "link.ply"
        real.write_text("old")
        real.chmod(0o640)
        link.symlink_to(real.name)
        self.applied(write_script("linked", (scripts.SMOOTHING, [])), target=link)
        self.assertTrue(link.is_symlink())
        self.assertEqual(real.stat().st_mode & 0o777, 0o640)
        self.assertEqual(ply.positions(real), ply.positions(smoothed_by_tool(noisy, "linked")))


class Readme(unittest.TestCase):
    def test_example(self):
        text = (SOURCE / "README.md").read_text(encoding="utf-8")
        script, command = (re.search(rf"<!-- {mark} -->\n```\w+\n(.*?)```", text, re.DOTALL).group(1)
                           for mark in ("file: smooth.mlx", "run: apply_mlx"))
        folder = work / "readme"
        (folder / "build").mkdir(parents=True)
        (folder / "build/plugins").symlink_to(PLUGIN.parent)
        (folder / "noisy.ply").symlink_to(noisy)
        (folder / "smooth.mlx").write_text(script)
        path = f"{pathlib.Path(APPLY_MLX).parent}:{os.environ['PATH']}"
        subprocess.run(["bash", "-e", "-c", command], check=True, cwd=folder, env={**os.environ, "PATH": path})
        self.assertEqual(ply.positions(folder / "smooth.ply"), ply.positions(smoothed_by_tool(noisy, "readme")))


class Wrong(unittest.TestCase):
    """Status 1, one line on standard error that says what, and the folder as it was."""

    def refused(self, script, *words, source=None, target=None, plugin=PLUGIN):
        folder = work / "refused"
        folder.mkdir(exist_ok=True)
        target = target or folder / "result.ply"
        (folder / "result.ply").write_text("precious")
        done = meshlab.apply_mlx("-i", source or noisy, "-o", target, "-s", script, "--plugin", plugin)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertEqual(len(done.stdout.splitlines()), 1, done.stdout)
        self.assertTrue(done.stdout.startswith("apply_mlx: "), done.stdout)
        for word in words:
            self.assertIn(str(word), done.stdout)
        self.assertEqual(os.listdir(folder), ["result.ply"])
        self.assertEqual((folder / "result.ply").read_text(), "precious")

    def test_unknown_filter(self):
        known = (scripts.SMOOTHING, [])
        self.refused(write_script("unknown_filter", known, ("Anisotropic Smoothing", [])), "'Anisotropic Smoothing'")

    def test_unknown_parameter(self):
        self.refused(write_script("unknown_parameter", (scripts.SMOOTHING, [number("sigma_x", "1")])), scripts.SMOOTHING,
                     "'sigma_x'", "sigma_c, sigma_s, sigma_n, rho, iterations, boundary, selected")

    def test_parameter_given_twice(self):
        self.refused(write_script("twice", (scripts.SMOOTHING, [number("rho", "1"), number("rho", "2")])), "rho", "twice")

    def test_values_of_another_kind(self):
        for index, (parameter, value, allowed) in enumerate((
                ("sigma_c", "two", "a number"), ("sigma_c", "", "a number"), ("iterations", "1.5", "a whole number"),
                ("selected", "maybe", "true or false"), ("boundary", "2", "0 (fixed), 1 (free)"),
                ("boundary", "free", "0 (fixed), 1 (free)"))):
            with self.subTest(f"{parameter}={value}"):
                self.refused(write_script(f"kind_{index}", (scripts.SMOOTHING, [number(parameter, value)])),
                             f"{parameter} is {value or 'empty'}; it must be", allowed)

    def test_value_missing(self):
        self.refused(write_script("no_value", (scripts.SMOOTHING, ['type="RichFloat" name="rho"'])), "rho has no value")

    def test_filter_that_fails_after_another_has_run(self):
        script = write_script("late", (scripts.BILATERAL, []), (scripts.SMOOTHING, [number("sigma_c", "-1")]))
        self.refused(script, f"filter '{scripts.SMOOTHING}'", "sigma_c is -1; it must be")

    def test_file_that_is_no_script(self):
        for name, text, word in (("text", "hello", "line 1"), ("other_root", "<Script/>", "<Script>"),
                                 ("no_filter", "<FilterScript/>", "no filter"),
                                 ("no_name", "<FilterScript><filter/></FilterScript>", "name"),
                                 ("no_param", '<FilterScript><filter name="x"><Parm/></filter></FilterScript>', "<Parm>"),
                                 ("cut_off", "<FilterScript><filter", "line 1")):
            with self.subTest(name):
                path = work / f"{name}.mlx"
                path.write_text(text)
                self.refused(path, path.name, word)
        self.refused(work / "absent.mlx", "absent.mlx", "cannot be read")

    def test_input(self):
        script = write_script("input", (scripts.SMOOTHING, []))
        broken = work / "broken.ply"
        broken.write_bytes(noisy.read_bytes()[:3000])
        other = work / "mesh.xyz_unknown"
        other.write_text("")
        self.refused(script, "absent.ply", "does not exist", source=work / "absent.ply")
        self.refused(script, "broken.ply", "cannot be read", source=broken)
        self.refused(script, "mesh.xyz_unknown", "format", "ply", source=other)
        self.refused(script, "not a file", source=work)

    def test_output(self):
        script = write_script("output", (scripts.SMOOTHING, []))
        (work / "folder.ply").mkdir()
        self.refused(script, "no folder", target=work / "absent" / "result.ply")
        self.refused(script, "folder.ply", "not a file", target=work / "folder.ply")
        self.refused(script, "result.unknown", "format", "ply", target=work / "result.unknown")

    def test_plugin(self):
        script = write_script("plugin", (scripts.SMOOTHING, []))
        self.refused(script, "absent.so", "no such plugin", plugin=work / "absent.so")
        other = work / "other.so"
        other.write_text("no plugin")
        self.refused(script, "other.so", "cannot be loaded", plugin=other)

    def test_command_line(self):
        for arguments in ((), ("-i", noisy), ("-i", noisy, "-o", work / "x.ply", "-s", work / "x.mlx", "--nonsense")):
            with self.subTest(arguments):
                self.assertEqual(meshlab.apply_mlx(*arguments).returncode, 2)
        self.assertIn(f"for MeshLab {os.environ['ANISO_MESHLAB_VERSION']}", meshlab.apply_mlx("--version").stdout)


if __name__ == "__main__":
    unittest.main()
