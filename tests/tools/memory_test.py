# SPDX-License-Identifier: GPL-3.0-or-later
"""Too little memory, at many limits of the address space: the error line and status 1, or the whole result."""

import os
import resource
import subprocess
import unittest

from command_line import PROGRAM, CommandLine

MIB = 1 << 20
STEPS = 16
COMMANDS = {
    "paper": ["smooth", "noisy.ply", "out.ply", "--threads", "3", "--report", "report.json"],
    "guided": ["smooth", "noisy.ply", "out.ply", "--method", "guided", "--threads", "3"],
    "jones": ["smooth", "noisy.ply", "out.ply", "--method", "jones", "--threads", "3"],
    "laplacian": ["smooth", "noisy.ply", "out.ply", "--method", "laplacian"],
    "obj": ["smooth", "noisy.obj", "out.obj"],
    "off": ["noise", "noisy.off", "out.off", "--level", "0.1"],
    "stl": ["noise", "noisy.stl", "out.stl", "--level", "0.1"],
    "geodesic": ["geodesic", "noisy.ply", "out.ply", "--start-vertex", "0"],
    "measure": ["measure", "noisy.ply", "clean.ply"],
    "generate": ["generate", "plane_delaunay", "out.ply", "--vertices", "6000"],
    "compare": ["compare", "noisy.ply", "clean.ply", "--out", "results", "--no-pictures", "--threads", "3"],
}


class Memory(CommandLine):
    def setUp(self):
        super().setUp()
        if os.environ.get("ANISO_SANITIZE"):
            self.skipTest("sanitizers need an address space without limit")
        self.noisy("cad_part", "6000")
        for kind in ("obj", "off", "stl"):
            self.run_tool("noise", "noisy.ply", f"noisy.{kind}", "--level", "0")

    def run_within(self, limit, arguments):
        def restrict():
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        return subprocess.run([PROGRAM, *arguments, *([] if arguments[0] in ("measure", "--version") else ["--quiet"])],
                              cwd=self.folder, capture_output=True, text=True, timeout=120, preexec_fn=restrict)

    def least(self, arguments):
        """A limit, to 1/4 MiB, below which the program does not do its work."""
        low, high = 0, 4
        while self.run_within(high * MIB // 4, arguments).returncode != 0:
            low, high = high, 2 * high
            self.assertLess(high, 1 << 16)
        while high - low > 1:
            middle = (low + high) // 2
            if self.run_within(middle * MIB // 4, arguments).returncode == 0:
                high = middle
            else:
                low = middle
        return high * MIB // 4

    def check(self, arguments):
        inputs = self.files()
        bottom, top = self.least(["--version"]), self.least(arguments)
        self.run_within(2 * top, arguments)
        results = {name: content for name, content in self.files().items() if name not in inputs}
        refused = 0
        for step in range(STEPS + 2):
            for name in results:
                with open(self.path(name), "wb") as file:
                    file.write(b"precious")
            limit = bottom + (top - bottom) * step // STEPS
            done = self.run_within(limit, arguments)
            found = self.files()
            self.assertEqual(set(found), set(inputs) | set(results), limit)
            if done.returncode == 0:
                for name, content in results.items():
                    if arguments[0] != "compare" or name.endswith(".ply"):  # its reports hold times
                        self.assertEqual(found[name], content)
                continue
            refused += 1
            self.assertEqual((done.returncode, done.stderr), (1, "anisosmooth: not enough memory for this mesh\n"),
                             f"limit {limit / MIB} MiB")
            for name, content in found.items():
                if arguments[0] != "compare" or name in inputs:
                    self.assertEqual(content, inputs.get(name, b"precious"), name)
        self.assertGreater(refused, STEPS // 3)


for label, command in COMMANDS.items():
    setattr(Memory, "test_" + label, lambda self, command=command: self.check(command))


if __name__ == "__main__":
    unittest.main()
