# SPDX-License-Identifier: GPL-3.0-or-later
"""The display of scripts/bench_processes: a free one, ready, and never waited for in vain."""

import importlib.machinery
import importlib.util
import os
import pathlib
import shutil
import tempfile
import unittest
from unittest import mock

SCRIPT = pathlib.Path(os.environ["ANISO_SOURCE"]) / "scripts/bench_processes"


def load():
    loader = importlib.machinery.SourceFileLoader("bench_processes", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class VirtualDisplay(unittest.TestCase):
    def setUp(self):
        self.virtual_display = load().virtual_display

    @unittest.skipIf(shutil.which("Xvfb") is None, "no Xvfb")
    def test_two_at_a_time_have_numbers_of_their_own(self):
        with self.virtual_display() as first, self.virtual_display() as second:
            self.assertRegex(first, r"^:\d+$")
            self.assertNotEqual(first, second)
            for name in (first, second):
                self.assertTrue(os.path.exists(f"/tmp/.X11-unix/X{name[1:]}"))
        self.assertFalse(os.path.exists(f"/tmp/.X11-unix/X{first[1:]}"))

    def test_a_display_that_does_not_start_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            with mock.patch.dict(os.environ, PATH=folder):
                with self.assertRaisesRegex(SystemExit, "Xvfb cannot be started"), self.virtual_display():
                    pass
                program = pathlib.Path(folder) / "Xvfb"
                program.write_text("#!/bin/sh\nexit 1\n")
                program.chmod(0o755)
                with self.assertRaisesRegex(SystemExit, "Xvfb did not start"), self.virtual_display():
                    pass


if __name__ == "__main__":
    unittest.main()
