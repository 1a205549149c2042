# SPDX-License-Identifier: GPL-3.0-or-later
"""What apply_mlx promises besides what test_scripts.py asks of every MeshLab: defaults for what a script leaves out,
several filters in their order, MeshLab's own filters and formats, and one clear line and nothing written when something
is wrong."""

import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import time
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "support"))

import decimal_comma  # noqa: E402
import flushes  # noqa: E402
import ply  # noqa: E402
import scripts  # noqa: E402
from environment import APPLY_MLX, PLUGIN, SOURCE, fresh_work_folder, make_meshlab, run_tool  # noqa: E402


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

    def test_a_link_to_nothing_stays_a_link_and_its_target_is_made(self):
        link = work / "dangling.ply"
        link.symlink_to("made.ply")
        self.applied(write_script("dangling", (scripts.SMOOTHING, [])), target=link)
        self.assertTrue(link.is_symlink())
        self.assertEqual(ply.positions(work / "made.ply"), ply.positions(smoothed_by_tool(noisy, "dangling")))

    def test_file_names_of_the_users_language(self):
        """In a locale with a decimal comma, where the numbers stay as in C and the names stay the user's."""
        script = write_script("umlaut", (scripts.SMOOTHING, []))
        source, target = work / "Tür.off", work / "Türgröße.off"
        run_tool("noise", noisy, source, "--level", "0")
        self.applied(script, source, work / "plain.off")
        with meshlab.in_locale(decimal_comma.environment(work / "locale")):
            self.applied(script, source, target)
        self.assertEqual(target.read_bytes(), (work / "plain.off").read_bytes())


def png(value):
    """A picture of 2 by 2 pixels, with a remark that a writer of pictures would not write again."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    pixels = 2 * (b"\0" + 6 * bytes([value]))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 2, 2, 8, 2, 0, 0, 0)) +
            chunk(b"tEXt", b"Comment\0painted by hand") + chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))


class Textures(unittest.TestCase):
    """Textures in folders of their own: they arrive beside the mesh or in folders below it, and nowhere else."""

    def setUp(self):
        self.top = work / self._testMethodName
        self.models = self.top / "project/scans/models/part"
        self.out = self.top / "results/deep/er"
        self.models.mkdir(parents=True)
        self.out.mkdir(parents=True)
        self.script = write_script("textured", ("Invert Faces Orientation", []))

    def model(self, *names):
        """An OBJ of one square for each texture's name."""
        lines, materials = ["mtllib model.mtl"], []
        for i, name in enumerate(names):
            materials += [f"newmtl m{i}", "Kd 1 1 1", f"map_Kd {name}"]
            for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
                lines += [f"v {x + 0.5} {y} {i}", f"vt {x} {y}"]
            lines.append(f"usemtl m{i}")
            lines += [f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in ((4 * i + 1, 4 * i + 2, 4 * i + 3),
                                                                   (4 * i + 1, 4 * i + 3, 4 * i + 4))]
        (self.models / "model.obj").write_text("\n".join([*lines, ""]))
        (self.models / "model.mtl").write_text("\n".join([*materials, ""]))
        return self.models / "model.obj"

    def picture(self, name, value):
        path = self.models / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(png(value))
        return path

    def files(self):
        return {path.relative_to(self.top).as_posix(): path.read_bytes() for path in self.top.rglob("*") if path.is_file()}

    def applied(self, source, target, **options):
        """The files that are new or other than before, and what was printed."""
        before = self.files()
        done = meshlab.apply_mlx("-i", source, "-o", target, "-s", self.script, **options)
        self.assertEqual(done.returncode, 0, done.stdout)
        after = self.files()
        self.assertEqual(set(before) - set(after), set())
        return {name: content for name, content in after.items() if before.get(name) != content}, done.stdout

    def expect_result(self, found, **textures):
        """In the results' folder the mesh, its materials and these textures, given by their picture's value."""
        names = {f"results/deep/er/{name}": png(value) for name, value in textures.items()}
        self.assertEqual(set(found), {"results/deep/er/out.obj", "results/deep/er/out.obj.mtl", *names})
        for name, content in names.items():
            self.assertEqual(found[name], content, name)

    def named(self):
        """The textures that the result names."""
        return re.findall(r"^map_Kd (.*)$", (self.out / "out.obj.mtl").read_text(), re.MULTILINE)

    def test_folders_below_the_mesh_stay(self):
        self.picture("textures/fine/wood.png", 10)
        self.picture("stone.png", 20)
        source = self.model("textures/fine/wood.png", "stone.png")
        found, _ = self.applied(source, self.out / "out.obj")
        self.expect_result(found, **{"textures/fine/wood.png": 10, "stone.png": 20})
        self.assertEqual(self.named(), ["textures/fine/wood.png", "stone.png"])
        self.assertEqual(self.applied(source, self.out / "out.obj")[0], {}, "nothing changes the second time")
        found, _ = self.applied(source, self.models / "other.obj")
        self.assertEqual({pathlib.Path(name).name for name in found}, {"other.obj", "other.obj.mtl"})

    def test_in_ply_too(self):
        self.picture("textures/wood.png", 10)
        found, _ = self.applied(self.model("textures/wood.png"), self.out / "out.ply")
        self.assertEqual(set(found), {"results/deep/er/out.ply", "results/deep/er/textures/wood.png"})
        self.assertIn(b"comment TextureFile textures/wood.png\n", found["results/deep/er/out.ply"])

    def test_names_that_lead_out_lose_their_directory(self):
        for number, name in enumerate(("../tex/wood.png", "../../../x.png", "a/../../b.png", self.top / "absolute.png")):
            with self.subTest(name):
                self.picture(name, number)
                base = pathlib.Path(name).name
                for place in ("results/deep/tex/wood.png", "x.png", "results/deep/b.png"):  # where they would go
                    (self.top / place).parent.mkdir(exist_ok=True)
                    (self.top / place).write_text("precious")
                found, _ = self.applied(self.model(name), self.out / "out.obj")
                picture = found["results/deep/er/" + base]
                self.assertTrue(picture.startswith(b"\x89PNG"))
                if base != "absolute.png":  # of an absolute name MeshLab itself keeps the picture alone, not its place
                    self.assertEqual(picture, png(number))
                self.assertLessEqual(set(found), {"results/deep/er/" + file for file in ("out.obj", "out.obj.mtl", base)})
                self.assertEqual(self.named(), [base])

    def test_what_is_in_its_place_already_stays(self):
        self.picture("../tex/wood.png", 1)
        self.picture("textures/stone.png", 2)
        source = self.model("../tex/wood.png", "textures/stone.png")
        for target in (self.models / "other.obj", source):
            found, _ = self.applied(source, target)
            self.assertLessEqual({pathlib.Path(name).name for name in found}, {target.name, target.name + ".mtl"})
            text = (self.models / (target.name + ".mtl")).read_text()
            self.assertEqual(re.findall(r"^map_Kd (.*)$", text, re.MULTILINE), ["../tex/wood.png", "textures/stone.png"])

    def test_a_name_that_somebody_else_has_is_not_taken(self):
        self.picture("wood.png", 1)
        self.picture("../wood.png", 2)
        self.picture("../stone.png", 3)
        (self.out / "stone.png").write_text("precious")
        found, _ = self.applied(self.model("wood.png", "../wood.png", "../stone.png"), self.out / "out.obj")
        self.expect_result(found, **{"wood.png": 1, "wood_1.png": 2, "stone_1.png": 3})
        self.assertEqual(self.named(), ["wood.png", "wood_1.png", "stone_1.png"])
        self.assertEqual((self.out / "stone.png").read_text(), "precious")
        self.assertEqual(self.applied(self.models / "model.obj", self.out / "out.obj")[0], {})

    def test_a_folder_that_is_a_link_to_elsewhere(self):
        elsewhere = self.top / "elsewhere"
        elsewhere.mkdir()
        (self.out / "textures").symlink_to(elsewhere)
        self.picture("textures/fine/wood.png", 1)
        found, _ = self.applied(self.model("textures/fine/wood.png"), self.out / "out.obj")
        self.expect_result(found, **{"wood.png": 1})

    def test_missing_textures_keep_their_names(self):
        self.picture("there.png", 1)
        found, printed = self.applied(self.model("lost/a.png", "there.png", "../b.png"), self.out / "out.obj")
        self.expect_result(found, **{"there.png": 1})
        self.assertEqual(self.named(), ["lost/a.png", "there.png", "../b.png"])
        for name in ("lost/a.png", "../b.png"):
            self.assertIn(f"texture {name} was not found", printed)

    def test_the_current_folder_does_not_matter(self):
        self.picture("textures/wood.png", 1)
        current = self.top / "current"
        (current / "textures").mkdir(parents=True)
        (current / "textures/wood.png").write_bytes(png(99))
        self.model("textures/wood.png")
        found, _ = self.applied("../project/scans/models/part/model.obj", "../results/deep/er/out.obj", cwd=current)
        found.pop("current/checkerboard.png", None)  # MeshLab 2025.07 leaves its stand-in for textures there
        self.expect_result(found, **{"textures/wood.png": 1})

    def test_all_is_flushed_to_the_disk_before_it_gets_its_name(self):
        self.picture("textures/fine/wood.png", 1)
        log = work / "flushes"
        self.applied(self.model("textures/fine/wood.png"), self.out / "out.obj",
                     **flushes.recorded(os.environ["ANISO_RECORD_FLUSHES"], log))
        found = flushes.renamed_files(self, log, self.out)
        self.assertEqual(found, [os.path.realpath(self.out / name) for name in ("textures/fine/wood.png", "out.obj.mtl",
                                                                                 "out.obj")])


class Interrupts(unittest.TestCase):
    def test_a_signal_while_writing_leaves_the_old_file_and_nothing_else(self):
        large, folder = work / "large.ply", work / "interrupted"
        run_tool("generate", "sphere", large, "--vertices", 100000)
        folder.mkdir()
        target = folder / "out.obj"
        script = write_script("interrupted", ("Invert Faces Orientation", []))
        interrupted = 0
        for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
            target.write_text("precious")
            process = subprocess.Popen([APPLY_MLX, "-i", large, "-o", target, "-s", script], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, env=meshlab.environment(""), text=True,
                                       preexec_fn=lambda: [signal.signal(n, signal.SIG_DFL) for n in (1, 2, 15)])
            while process.poll() is None and len(os.listdir(folder)) == 1:
                time.sleep(0.001)
            process.send_signal(number)
            words = process.communicate(timeout=60)[1]
            self.assertIn(process.returncode, (0, -number), words)
            if process.returncode == 0:  # the file was complete already
                continue
            interrupted += 1
            self.assertEqual(os.listdir(folder), ["out.obj"])
            self.assertEqual(target.read_text(), "precious")
        self.assertGreater(interrupted, 0, "the signals came too late")


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
