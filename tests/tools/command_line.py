# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the command line share. ANISOSMOOTH names the program."""

import os
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.path.abspath(os.environ["ANISOSMOOTH"])
FORMATS = ("ply", "obj", "off", "stl")


class CommandLine(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_tool(self, *arguments, status=0, environment=None):
        result = subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=60,
                                env={**os.environ, **(environment or {})})
        self.assertEqual(result.returncode, status, f"{arguments}: {result.stdout}{result.stderr}")
        return result

    def mount_namespace(self):
        """Makes small/, and returns what runs a command that may mount a file system there, gone when it ends."""
        namespace = ["unshare", "--mount", "--map-root-user"] if os.geteuid() != 0 else ["unshare", "--mount"]
        if subprocess.run([*namespace, "mount", "-t", "tmpfs", "none", self.folder], check=False,
                          capture_output=True).returncode != 0:
            self.skipTest("needs the right to mount a file system of its own")
        os.mkdir(self.path("small"))
        return namespace

    def noisy(self, shape="cad_part", vertices="3000", *options):
        self.run_tool("generate", shape, "clean.ply", "--vertices", vertices, *options)
        self.run_tool("noise", "clean.ply", "noisy.ply", "--level", "0.2", "--seed", "3")

    def bytes_of(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def expect_failure(self, *arguments, says, status=1):
        """One line on stderr, nothing on stdout, no file made or changed."""
        before = self.files()
        result = self.run_tool(*arguments, status=status)
        self.assertEqual(result.stdout, "")
        for text in says if isinstance(says, tuple) else (says,):
            self.assertIn(text, result.stderr)
        if status == 1:
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertEqual(self.files(), before)

    def files(self):
        """The content of the test's folder, hidden files too."""
        found = {}
        for folder, _, names in os.walk(self.folder):
            for name in names:
                path = os.path.join(folder, name)
                if os.path.isfile(path) and not os.path.islink(path):
                    found[os.path.relpath(path, self.folder)] = self.bytes_of(path)
        return found
