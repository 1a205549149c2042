# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/real_files: with the real program on files of all kinds, and with programs that fail in every way."""

import json
import os
import re
import stat
import subprocess
import sys
import unittest

from command_line import PROGRAM, CommandLine

SCRIPT = os.path.join(os.environ["ANISO_SOURCE"], "scripts", "real_files")
CUBE = """OFF
8 12 0
0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1
3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n3 2 6 3\n3 3 6 7\n3 0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5
"""
GOOD = {"average_edge_length": 2.0, "max_displacement": 1.0, "faces": 1000, "flipped_faces": 0, "volume_before": 10.0,
        "volume_after": 10.0, "closed": True, "beyond_ring_vertices": 0, "warnings": []}


class RealFiles(CommandLine):
    def run_script(self, *arguments, program=PROGRAM, status=0):
        result = subprocess.run([sys.executable, "-B", SCRIPT, *arguments, "--program", program], cwd=self.folder,
                                capture_output=True, text=True, timeout=300)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def write(self, name, text):
        path = self.path(name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def counts(self, output, name):
        """One row of the table at the end, its last column the sum."""
        (row,) = re.findall(rf"^{re.escape(name)}  +([\d .]+)$", output, re.MULTILINE)
        return [int(n) for n in row.split()]

    def program(self, *lines):
        """A program in the place of anisosmooth: smooth IN OUT ... --report FILE."""
        self.write("program", "\n".join(["#!/bin/bash", 'report=${!#}', *lines]) + "\n")
        os.chmod(self.path("program"), stat.S_IRWXU)
        return self.path("program")

    def program_that_reports(self, **changes):
        return self.program(f"echo '{json.dumps({**GOOD, **changes})}' >\"$report\"")

    def test_every_file_and_method_has_a_line_and_is_counted(self):
        os.mkdir(self.path("deep"))
        self.run_tool("generate", "cad_part", "deep/clean.ply", "--vertices", "2000")
        self.run_tool("noise", "deep/clean.ply", "deep/noisy.STL", "--level", "0.2")
        self.write("deep/down/cube.off", CUBE)
        self.write("broken.obj", "nothing of use\n")
        self.write("text.txt", "no mesh\n")
        before = self.files()
        out = self.run_script(".", "--methods", "paper,taubin", "--jobs", "2").stdout
        lines = [line for line in out.splitlines() if re.match(r"(done|refused|over its time|crashed) +[\d.]+ s ", line)]
        self.assertEqual(len(lines), 8, out)
        self.assertEqual(self.files(), before, "nothing is kept")
        (cube,) = [line for line in lines if "cube.off" in line and " paper " in line]
        self.assertRegex(cube, r"^done .* 0\.\d+ e +0\.00 % +\+37\.\d\d % +1  paper +deep/down/cube\.off$")
        self.assertEqual(sum("broken.obj: anisosmooth: " in line and line.startswith("refused") for line in lines), 2, out)
        self.assertEqual(self.counts(out, "files"), [4, 4, 8])
        self.assertEqual(self.counts(out, "refused"), [1, 1, 2])
        self.assertEqual(self.counts(out, "crashed"), [0, 0, 0])
        self.assertEqual(self.counts(out, "volume off over 5 %")[0], 1)
        self.assertEqual(self.counts(out, "bad")[0], 1)
        self.assertEqual(self.counts(out, "bad and silent"), [0, 0, 0])

    def test_programs_that_fail(self):
        self.write("mesh.off", CUBE)
        endless = self.program("while :; do :; done")
        out = self.run_script("mesh.off", "--methods", "paper", "--timeout", "1", program=endless, status=1).stdout
        self.assertEqual(self.counts(out, "over its time"), [1, 1], out)
        out = self.run_script("mesh.off", "--methods", "paper", program=self.program("kill -SEGV $$"), status=1).stdout
        self.assertEqual(self.counts(out, "crashed"), [1, 1], out)
        out = self.run_script("mesh.off", "--methods", "paper", program=self.program("exit 0"), status=1).stdout
        self.assertEqual(self.counts(out, "crashed"), [1, 1], "without a report: " + out)
        sleeping = self.program("sleep 60")
        out = self.run_script("mesh.off", "--methods", "paper", "--timeout", "0.1", program=sleeping, status=1).stdout
        self.assertEqual(self.counts(out, "over its time"), [1, 1], out)

    def test_bad_results_without_a_warning_are_found(self):
        self.write("mesh.off", CUBE)
        cases = (({}, ()),
                 ({"flipped_faces": 11}, ("bad",)),
                 ({"flipped_faces": 51}, ("bad", "over 5 % turned")),
                 ({"volume_after": 10.6}, ("bad", "volume off over 5 %")),
                 ({"volume_after": 4.0}, ("bad", "volume off over 5 %", "volume off over 50 %")),
                 ({"volume_after": 4.0, "closed": False}, ()),
                 ({"max_displacement": 4.1}, ("bad",)),
                 ({"max_displacement": 6.1}, ("bad", "moved over 3 e")),
                 ({"beyond_ring_vertices": 1}, ("bad",)),
                 ({"average_edge_length": None, "max_displacement": None, "volume_after": None}, ()))
        for changes, expected in cases:
            for warnings in ([], ["a word"]):
                silent = "bad" in expected and not warnings
                out = self.run_script("mesh.off", "--methods", "paper", status=int(silent),
                                      program=self.program_that_reports(**changes, warnings=warnings)).stdout
                for name in ("bad", "over 5 % turned", "volume off over 5 %", "volume off over 50 %", "moved over 3 e"):
                    self.assertEqual(self.counts(out, name), [name in expected] * 2, f"{changes}: {name}\n{out}")
                self.assertEqual(self.counts(out, "bad and silent"), [silent] * 2, f"{changes}\n{out}")

    def test_wrong_command_lines(self):
        os.mkdir(self.path("empty"))
        for arguments, says in ((["nowhere"], "nowhere is not there"), (["empty"], "no file ends in .obj, .off, .ply, .stl"),
                                ([".", "--timeout", "0"], "must be positive")):
            self.assertIn(says, self.run_script(*arguments, status=2).stderr)
        self.assertIn("is not there", self.run_script(".", program="/no/such/program", status=2).stderr)


if __name__ == "__main__":
    unittest.main()
