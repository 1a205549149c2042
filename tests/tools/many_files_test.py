# SPDX-License-Identifier: GPL-3.0-or-later
"""anisosmooth smooth IN... --out-dir DIR: each file for itself."""

import json
import os
import pty
import re
import signal
import subprocess
import time
import unittest

from command_line import FORMATS, PROGRAM, CommandLine


class ManyFiles(CommandLine):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("scans"))
        for kind in FORMATS:
            self.run_tool("generate", "cube", "clean.ply", "--vertices", "300", "--quiet")
            self.run_tool("noise", "clean.ply", f"scans/{kind}.{kind}", "--level", "0.2", "--quiet")
        os.remove(self.path("clean.ply"))

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def test_each_is_what_it_is_alone(self):
        os.rename(self.path("scans/stl.stl"), self.path("alone.stl"))
        self.write("scans/notes.txt", "no mesh\n")
        os.mkdir(self.path("scans/deep.ply"))
        os.symlink("nowhere.ply", self.path("scans/link.ply"))
        done = self.run_tool("smooth", "alone.stl", "scans", "--out-dir", "new/out", "--method", "taubin", "--iterations",
                             "3", "--report", "report.json")
        self.assertEqual(done.stderr, "")
        inputs = ["alone.stl", "scans/obj.obj", "scans/off.off", "scans/ply.ply"]
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 4, done.stdout)
        with open(self.path("report.json"), encoding="utf-8") as file:
            reports = json.load(file)
        self.assertEqual([report["input"] for report in reports], inputs)
        for name, line, report in zip(inputs, lines, reports):
            out = "new/out/" + os.path.basename(name)
            self.assertRegex(line, f"^{name}: moved \\d+ of \\d+ vertices; .*; written to {out}$")
            single = "single" + os.path.splitext(name)[1]
            self.run_tool("smooth", name, single, "--method", "taubin", "--iterations", "3", "--report", "single.json")
            self.assertEqual(self.bytes_of(out), self.bytes_of(single), name)
            with open(self.path("single.json"), encoding="utf-8") as file:
                self.assertEqual(report, {"input": name, "output": out, **json.load(file)})
        self.assertEqual(sorted(os.listdir(self.path("new/out"))), ["alone.stl", "obj.obj", "off.off", "ply.ply"])

    def test_a_bad_one_does_not_stop_the_others(self):
        self.write("scans/bad.obj", "v 0 0\n")
        self.write("scans/none.off", "OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n")
        done = self.run_tool("smooth", "scans", "missing.ply", "scans.txt", "--out-dir", "out", "--report", "report.json",
                             status=1)
        errors = [line for line in done.stderr.splitlines() if not line.startswith("warning: scans/")]
        self.assertEqual(len(errors), 5, done.stderr)
        for line, says in zip(errors, ("scans/bad.obj, line 1: a vertex", "scans/none.off: ", "missing.ply: does not exist",
                                       "unknown extension '.txt'", "4 of 8 files could not be smoothed")):
            self.assertTrue(line.startswith("anisosmooth: "), line)
            self.assertIn(says, line)
        self.assertEqual(len(done.stdout.splitlines()), 4)
        self.assertEqual(len(os.listdir(self.path("out"))), 4)
        with open(self.path("report.json"), encoding="utf-8") as file:
            reports = json.load(file)
        self.assertEqual(["error" in report for report in reports], [True, True] + [False] * 4 + [True] * 2)
        for report in reports:
            self.assertEqual("moved_vertices" in report, "error" not in report)

    def test_warnings_name_their_file(self):
        self.write("a.off", "OFF\n5 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 2 2\n2 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
        self.write("b.off", self.bytes_of("a.off").decode())
        done = self.run_tool("smooth", "a.off", "b.off", "--out-dir", "out", "--quiet")
        self.assertEqual(done.stdout, "")
        lines = done.stderr.splitlines()
        self.assertGreaterEqual(len(lines), 4, done.stderr)
        half = len(lines) // 2
        self.assertEqual(lines[half:], [line.replace("a.off", "b.off") for line in lines[:half]])
        for line in lines[:half]:
            self.assertTrue(line.startswith("warning: a.off: "), line)

    def test_what_cannot_be_told_apart_or_is_not_there_is_refused_before_anything_is_done(self):
        os.mkdir(self.path("other"))
        os.mkdir(self.path("empty"))
        self.write("other/ply.ply", "not read\n")
        self.expect_failure("smooth", "scans", "other/ply.ply", "--out-dir", "out",
                            says=("other/ply.ply: has the same name as scans/ply.ply", "out/ply.ply"))
        self.expect_failure("smooth", "scans", "scans/obj.obj", "--out-dir", "out", says="has the same name")
        self.expect_failure("smooth", "empty", "--out-dir", "out", says=("empty: holds no meshes", ".ply, .obj, .off, .stl, .glb and .gltf"))
        self.expect_failure("smooth", "scans", "--out-dir", "other/ply.ply", says="other/ply.ply: cannot be made a folder")
        self.expect_failure("smooth", "scans", "--out-dir", "out", "--sigma-c", "-1", says="sigma_c")
        self.assertFalse(os.path.exists(self.path("out")))
        self.expect_failure("smooth", "scans", "--out-dir", "other", "--report", "other/stl.stl", says="report is")
        self.expect_failure("smooth", "scans", "--out-dir", "other", "--report", "scans/obj.obj", says="report is")
        for arguments in (["scans/ply.ply"], ["a.ply", "b.ply", "c.ply"], ["--out-dir", "out"]):
            self.expect_failure("smooth", *arguments, says="--help", status=2)

    def test_the_folder_may_be_the_one_of_the_files(self):
        self.run_tool("smooth", "scans", "--out-dir", "out", "--quiet")
        self.run_tool("smooth", "scans", "--out-dir", "scans", "--quiet")
        for kind in FORMATS:
            self.assertEqual(self.bytes_of(f"scans/{kind}.{kind}"), self.bytes_of(f"out/{kind}.{kind}"))

    def test_progress_is_over_all(self):
        for name in ("y.ply", "z.ply"):
            self.run_tool("generate", "cad_part", name, "--vertices", "20000", "--quiet")
        leader, follower = pty.openpty()
        process = subprocess.Popen([PROGRAM, "smooth", "y.ply", "z.ply", "--out-dir", "out", "--sigma-c", "6", "--iterations",
                                    "8", "--threads", "1"], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=follower)
        os.close(follower)
        seen = b""
        while b"2 of 2: " not in seen:
            try:
                seen += os.read(leader, 4096)
            except OSError:
                break
        process.kill()
        process.communicate(timeout=60)
        os.close(leader)
        shown = [(int(percent), number) for percent, number in re.findall(r"(\d+) % (\d) of 2: \w", seen.decode())]
        self.assertEqual(shown, sorted(shown))
        self.assertEqual({number for _, number in shown}, {"1", "2"})
        for percent, number in shown:
            self.assertTrue(percent <= 50 if number == "1" else percent >= 50, shown)

    def test_an_interrupt_leaves_what_is_finished(self):
        self.run_tool("generate", "cad_part", "z.ply", "--vertices", "60000", "--quiet")
        process = subprocess.Popen([PROGRAM, "smooth", "scans", "z.ply", "--out-dir", "out", "--report", "r.json",
                                    "--method", "guided", "--iterations", "50"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        while process.poll() is None and not os.path.exists(self.path("out/stl.stl")):
            time.sleep(0.002)
        process.send_signal(signal.SIGINT)
        words = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 130, words)
        self.assertNotIn(b"anisosmooth:", words)
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["obj.obj", "off.off", "ply.ply", "stl.stl"])
        self.assertFalse(os.path.exists(self.path("r.json")))
        self.run_tool("smooth", "scans", "--out-dir", "whole", "--method", "guided", "--iterations", "50", "--quiet")
        for kind in FORMATS:
            self.assertEqual(self.bytes_of(f"out/{kind}.{kind}"), self.bytes_of(f"whole/{kind}.{kind}"))


if __name__ == "__main__":
    unittest.main()
