# SPDX-License-Identifier: GPL-3.0-or-later
"""anisosmooth compare from end to end: files, figures, pictures, failures. ANISOSMOOTH names the program."""

import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.path.abspath(os.environ["ANISOSMOOTH"])
METHODS = ["laplacian", "hc", "taubin", "jones", "bmd", "paper"]
PICTURES = ["figure9.png", "errors.png"]
RENDERERS = ["f3d", "xvfb-run", "xauth", "montage", "convert", "mogrify"]


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.tool("generate", "cad_part", "clean.ply", "--vertices", "2000")
        cls.tool("noise", "clean.ply", "noisy.ply", "--level", "0.2", "--seed", "3")

    @classmethod
    def tool(cls, *arguments, status=0, path=None):
        environment = dict(os.environ, PATH=path or os.environ["PATH"])
        result = subprocess.run([PROGRAM, *arguments], cwd=cls.folder, capture_output=True, text=True, timeout=600,
                                env=environment)
        assert result.returncode == status, f"{arguments}: {result.returncode}: {result.stdout}{result.stderr}"
        return result

    def report(self, out):
        return json.loads((self.folder / out / "report.json").read_text())

    def test_results_are_those_of_smooth_and_figures_those_of_measure(self):
        self.tool("compare", "noisy.ply", "clean.ply", "--out", "full", "--no-pictures")
        report = self.report("full")
        self.assertEqual([m["method"] for m in report["methods"]], METHODS)
        for entry in report["methods"]:
            with self.subTest(entry["method"]):
                self.tool("smooth", "noisy.ply", "one.ply", "--method", entry["method"], "--report", "one.json")
                result = (self.folder / "full" / entry["file"]).read_bytes()
                self.assertEqual(result, (self.folder / "one.ply").read_bytes())
                alone = json.loads((self.folder / "one.json").read_text())
                self.assertEqual(entry["parameters"], alone["parameters"])
                self.assertEqual(entry["report"]["rms_displacement"], alone["rms_displacement"])
                measured = json.loads(self.tool("measure", "one.ply", "clean.ply", "--noisy", "noisy.ply",
                                                "--json").stdout)
                self.assertEqual(entry["figures"].keys(), measured.keys())
                # compare measures what it has in memory, in double; the file is in float.
                for name, value in measured.items():
                    self.assertAlmostEqual(entry["figures"][name], value, delta=1e-5 * (1 + abs(value)), msg=name)
                self.assertGreater(entry["seconds"], 0)
        parameters = {m["method"]: m["parameters"] for m in report["methods"]}
        self.assertEqual(parameters["paper"]["sigma_n"], 0.3)
        self.assertEqual(parameters["taubin"]["iterations"], 20)
        text = (self.folder / "full" / "report.md").read_text()
        for entry in report["methods"]:
            self.assertIn(entry["title"], text)
            self.assertIn(f"{entry['figures']['normal_error_mean']:.2f}", text)

    def test_without_reference(self):
        self.tool("compare", "noisy.ply", "--out", "alone", "--no-pictures", "--quiet")
        report = self.report("alone")
        self.assertNotIn("figures", report["methods"][0])
        self.assertEqual(report["pictures"], [])
        self.assertEqual(len(list((self.folder / "alone").iterdir())), len(METHODS) + 2)

    @unittest.skipIf(any(shutil.which(name) is None for name in RENDERERS), "no renderer")
    def test_pictures(self):
        # A folder's name that a shell would take apart.
        for out, reference in (("with pictures & $HOME", ["clean.ply"]), ("no truth", [])):
            result = self.tool("compare", "noisy.ply", *reference, "--out", out)
            self.assertEqual(result.stderr, "")
            self.assertEqual(self.report(out)["pictures"], PICTURES)
            names = {f"{m}.ply" for m in METHODS} | {"report.json", "report.md", *PICTURES}
            self.assertEqual({path.name for path in (self.folder / out).iterdir()}, names)
            for name in PICTURES:
                width, height = self.size_of_png(self.folder / out / name)
                self.assertGreater(width, 7 * 300)
                self.assertGreater(height, 450 if name == "figure9.png" else 150)
                self.assertIn(f"]({name})", (self.folder / out / "report.md").read_text())
        # Six methods, one noisy mesh: no two columns of the sheet are alike, and each shows something.
        sheet = self.folder / "with pictures & $HOME" / "figure9.png"
        means = subprocess.run(["convert", sheet, "-crop", "7x1@", "+repage", "-format", "%#:%[fx:mean]\n", "info:"],
                               capture_output=True, text=True, check=True).stdout.split()
        self.assertEqual(len(set(means)), 7, means)
        for mean in means:
            self.assertLess(float(mean.split(":")[1]), 0.95, "nearly white: nothing was drawn")

    @unittest.skipIf(any(shutil.which(name) is None for name in RENDERERS), "no renderer")
    def test_an_interrupt_while_drawing_ends_at_once_and_leaves_no_work(self):
        process = subprocess.Popen([PROGRAM, "compare", "noisy.ply", "--out", "interrupted"], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        folder = self.folder / "interrupted"
        deadline = time.monotonic() + 60
        while not list(folder.glob(".pictures-*/*_whole.png")) and time.monotonic() < deadline:
            time.sleep(0.02)
        start = time.monotonic()
        process.send_signal(signal.SIGINT)  # to the program alone, as a shell script's trap would
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertLess(time.monotonic() - start, 5)
        self.assertEqual(list(folder.glob(".pictures-*")), [])
        self.assertFalse((folder / "figure9.png").exists())

    def size_of_png(self, path):
        data = path.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        return struct.unpack(">II", data[16:24])

    def test_says_which_renderer_is_missing_and_delivers_the_rest(self):
        programs = self.folder / "programs"
        programs.mkdir()
        for name in ("sh", "xvfb-run", "montage"):
            if shutil.which(name):
                (programs / name).symlink_to(shutil.which(name))
        result = self.tool("compare", "noisy.ply", "clean.ply", "--out", "blind", path=str(programs))
        self.assertEqual(result.stderr, "warning: no pictures: the program f3d is missing (Debian's package f3d)\n")
        self.assertEqual(self.report("blind")["pictures"], [])
        self.assertTrue((self.folder / "blind" / "paper.ply").exists())

    def test_a_renderer_that_fails_is_told_and_leaves_nothing(self):
        programs = self.folder / "broken"
        programs.mkdir()
        for name in RENDERERS:
            (programs / name).write_text("#!/bin/sh\necho cannot open display\nexit 7\n")
            (programs / name).chmod(0o755)
        result = self.tool("compare", "noisy.ply", "--out", "failed", path=f"{programs}:{os.environ['PATH']}")
        self.assertEqual(result.stderr, "warning: no pictures: xvfb-run ended with status 7: cannot open display\n")
        self.assertEqual(len(list((self.folder / "failed").iterdir())), len(METHODS) + 2)

    def test_a_status_is_kept_where_the_parent_ignores_those_of_children(self):
        programs = self.folder / "failing"
        programs.mkdir()
        for name in RENDERERS:
            (programs / name).write_text("#!/bin/sh\necho no light\nexit 7\n")
            (programs / name).chmod(0o755)
        done = subprocess.run([PROGRAM, "compare", "noisy.ply", "--out", "orphaned"], cwd=self.folder, capture_output=True,
                              text=True, timeout=110, env=dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}"),
                              preexec_fn=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN))
        self.assertEqual((done.returncode, done.stderr),
                         (0, "warning: no pictures: xvfb-run ended with status 7: no light\n"))
        self.assertFalse((self.folder / "orphaned/figure9.png").exists())

    def test_names_that_are_not_utf_8(self):
        name = b"a\xff.ply"
        shutil.copy(self.folder / "noisy.ply", os.path.join(os.fsencode(self.folder), name))
        self.tool("compare", name, "clean.ply", "--out", "odd", "--no-pictures")
        self.assertEqual(self.report("odd")["noisy"], "a\ufffd.ply")
        self.assertEqual(len(list((self.folder / "odd").iterdir())), len(METHODS) + 2)

    def test_failures_leave_no_folder(self):
        self.tool("generate", "cad_part", "other.ply", "--vertices", "2500")
        self.tool("generate", "sphere", "sphere.ply", "--vertices", "500")
        for arguments in (["noisy.ply", "other.ply"], ["missing.ply"], ["noisy.ply", "missing.ply"],
                          ["noisy.ply", "--up", "w"], ["noisy.ply", "--view", "0,0,1"]):
            with self.subTest(arguments):
                result = self.tool("compare", *arguments, "--out", "nothing", status=1)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertEqual(result.stdout, "")
                self.assertFalse((self.folder / "nothing").exists())
        result = self.tool("compare", "noisy.ply", "--out", "clean.ply", "--no-pictures", status=1)
        self.assertIn("clean.ply: cannot be made a folder", result.stderr)
        self.tool("compare", "noisy.ply", status=2)


if __name__ == "__main__":
    unittest.main()
