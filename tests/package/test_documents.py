# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of parameters in the documents are those of the program, and scripts/document_parameters sees where they are
not."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
DOCUMENTS = ("README.md", "docs/command-line.md")


def run(*options):
    return subprocess.run([SOURCE / "scripts/document_parameters", "--program", os.environ["ANISO_DESCRIBE"], *options],
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


class Documents(unittest.TestCase):
    def test_are_current(self):
        done = run("--check")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_that_are_not_current_are_named_and_mended(self):
        for name in DOCUMENTS:
            with tempfile.TemporaryDirectory() as folder, self.subTest(document=name):
                root = pathlib.Path(folder)
                (root / "docs").mkdir()
                for document in DOCUMENTS:
                    shutil.copy(SOURCE / document, root / document)
                path = root / name
                text = path.read_text(encoding="utf-8")
                stale = text.replace("above 0, at most 10", "above 0, at most 20")
                self.assertTrue(stale != text)
                path.write_text(stale, encoding="utf-8")
                done = run("--check", "--root", root)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(name, done.stdout)
                self.assertTrue(path.read_text(encoding="utf-8") == stale, "--check writes nothing")
                self.assertEqual(run("--root", root).returncode, 0)
                self.assertTrue(path.read_text(encoding="utf-8") == text)


if __name__ == "__main__":
    unittest.main()
