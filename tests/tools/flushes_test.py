# SPDX-License-Identifier: GPL-3.0-or-later
"""What a power cut leaves: every file of a result is flushed to the disk before it gets its name, and its folder then."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))

import flushes  # noqa: E402
from command_line import CommandLine  # noqa: E402


class Flushes(CommandLine):
    def setUp(self):
        super().setUp()
        if os.environ.get("ANISO_SANITIZE"):
            self.skipTest("sanitizers want to be the first library")
        self.noisy("cube", "400")
        self.run_tool("geodesic", "noisy.ply", "colored.ply", "--start-vertex", "0", "--quiet")

    def flushed_files(self, arguments):
        """What the command has put in place, in its order, relative to the test's folder."""
        log = self.path("log")
        self.run_tool(*arguments, environment=flushes.recorded(os.environ["RECORD_FLUSHES_LIBRARY"], log))
        found = flushes.renamed_files(self, log, self.folder)
        os.remove(log)
        return [os.path.relpath(path, os.path.realpath(self.folder)) for path in found]

    def expect_flushed(self, arguments, *files):
        self.assertEqual(self.flushed_files(arguments), list(files))

    def test_every_command_and_format(self):
        for kind in ("ply", "off", "stl"):
            self.expect_flushed(("noise", "noisy.ply", f"x.{kind}", "--level", "0.1"), f"x.{kind}")
        self.expect_flushed(("generate", "cube", "g.ply"), "g.ply")
        self.expect_flushed(("geodesic", "noisy.ply", "d.ply", "--start-vertex", "0"), "d.ply")

    def test_the_mesh_comes_last_of_what_belongs_together(self):
        with open(self.path("red.off"), "w") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n")
        os.mkdir(self.path("reports"))
        os.mkdir(self.path("deep"))
        os.symlink("deep/real.obj", self.path("link.obj"))
        self.expect_flushed(("smooth", "red.off", "red.obj", "--report", "reports/r.json"), "red.obj.mtl",
                            "reports/r.json", "red.obj")
        self.expect_flushed(("smooth", "noisy.ply", "link.obj"), "deep/real.obj")

    def test_compare(self):
        found = self.flushed_files(("compare", "noisy.ply", "--out", "results", "--no-pictures"))
        self.assertEqual(sorted(found), sorted("results/" + name for name in os.listdir(self.path("results"))))


if __name__ == "__main__":
    unittest.main()
