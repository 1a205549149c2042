# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts that make a folder anew delete only what they have made themselves."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SCRIPTS = pathlib.Path(os.environ["ANISO_SOURCE"]) / "scripts"
PLUGIN = os.environ.get("ANISO_PLUGIN", "")
LIBRARY = os.environ.get("ANISO_MESHLAB_LIBRARY", "")
HAS_SERVER = pathlib.Path("/usr/bin/meshlabserver").exists()  # until MeshLab 2020.09


class OwnFolders(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def run_script(self, name, *arguments, **environment):
        return subprocess.run([SCRIPTS / name, *arguments], check=False, capture_output=True, text=True, timeout=120,
                              cwd=self.folder, env={**os.environ, **environment})

    def precious(self, name):
        """A folder that somebody else has made."""
        folder = self.folder / name
        (folder / "deep").mkdir(parents=True)
        (folder / "deep/letter").write_text("precious")
        return folder

    def expect_refused(self, folder, script, *arguments, **environment):
        before = sorted(self.folder.rglob("*"))
        done = self.run_script(script, *arguments, **environment)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(f"{script}: '{folder}' is not a folder that {script} has made", done.stderr)
        self.assertEqual((folder / "deep/letter").read_text(), "precious")
        return before

    def test_private_meshlab_keeps_what_it_has_not_made(self):
        home = self.precious("home")
        before = self.expect_refused(home, "private_meshlab", home, __file__)
        self.assertEqual(sorted(self.folder.rglob("*")), before)
        (home / ".made_by_meshlab_root").touch()  # another script's
        self.expect_refused(home, "private_meshlab", home, __file__)
        letter = home / "deep/letter"
        self.assertNotEqual(self.run_script("private_meshlab", letter, __file__).returncode, 0)
        self.assertEqual(letter.read_text(), "precious")
        self.assertNotEqual(self.run_script("private_meshlab", "", __file__).returncode, 0)

    @unittest.skipIf(os.geteuid() == 0, "root may look everywhere")
    def test_a_folder_that_cannot_be_looked_into_is_kept(self):
        home = self.precious("home")
        home.chmod(0o300)
        self.assertNotEqual(self.run_script("private_meshlab", home, __file__).returncode, 0)
        home.chmod(0o700)
        self.assertEqual((home / "deep/letter").read_text(), "precious")

    @unittest.skipUnless(HAS_SERVER and PLUGIN, "needs MeshLab 2020.09 and the plugin")
    def test_private_meshlab_makes_its_own_anew(self):
        (self.folder / "empty").mkdir()
        for prefix in (self.folder / "empty", self.folder / "new/prefix"):
            for _ in range(2):
                done = self.run_script("private_meshlab", prefix, PLUGIN, LIBRARY)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue((prefix / "bin/meshlab").exists())
                self.assertFalse((prefix / "stale").exists())
                (prefix / "stale").touch()

    def test_fetch_meshlab_source_keeps_what_it_has_not_made(self):
        folder = self.precious("src")
        before = self.expect_refused(folder, "fetch_meshlab_source", folder)
        self.assertEqual(sorted(self.folder.rglob("*")), before)
        (folder / "ML_VERSION").write_text("1.0\n")  # somebody's own copy of another version
        self.expect_refused(folder, "fetch_meshlab_source", folder)

    def test_meshlab_root_keeps_what_it_has_not_made(self):
        for name in ("documents", "documents.part"):
            with self.subTest(name):
                folder = self.precious(name)
                # It ends before it would need rights or the network.
                self.expect_refused(folder, "meshlab_root", "documents", ANISO_ROOTS=str(self.folder))
                shutil.rmtree(folder)

    def test_a_suite_is_a_word(self):
        roots = self.folder / "cache/roots"
        roots.mkdir(parents=True)
        important = self.precious("important")
        before = sorted(self.folder.rglob("*"))
        for script, rest in (("meshlab_root", []), ("in_root", ["true"]), ("test_in_root", []), ("test_tree", [])):
            for suite in ("../../important", "Trixie", "a b", ".", "", "-x", "trixie\nx"):
                with self.subTest(script=script, suite=suite):
                    done = self.run_script(script, suite, *rest, ANISO_ROOTS=str(roots))
                    self.assertEqual(done.returncode, 2, done.stderr)
                    self.assertIn(f"usage: scripts/{script} SUITE", done.stderr)
                    self.assertEqual(sorted(self.folder.rglob("*")), before)
        self.assertEqual((important / "deep/letter").read_text(), "precious")


if __name__ == "__main__":
    unittest.main()
