# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin file itself: what it shows to the process that loads it and what it needs."""

import re
import subprocess
import unittest

from environment import PLUGIN, SOURCE, TOOL


class Binary(unittest.TestCase):
    def test_only_the_plugin_entry_points_are_visible(self):
        listing = subprocess.run(["nm", "-D", "--defined-only", PLUGIN], check=True, capture_output=True, text=True)
        symbols = {line.split()[-1] for line in listing.stdout.splitlines()}
        self.assertEqual(symbols, {"qt_plugin_instance", "qt_plugin_query_metadata"})

    def test_needs_no_library_that_meshlab_does_not_bring(self):
        dynamic = subprocess.run(["readelf", "-d", PLUGIN], check=True, capture_output=True, text=True).stdout
        needed = set(re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic))
        allowed = re.compile(r"libmeshlab-common\.so|libQt5\w+\.so\.5|lib(stdc\+\+|m|gcc_s|c|pthread)\.so\.\d+|ld-linux.*"
                             r"|lib(GL|OpenGL|GLEW|GLU)\.so[.\d]*")
        self.assertEqual([name for name in needed if not allowed.fullmatch(name)], [])
        self.assertNotRegex(dynamic, r"\((RPATH|RUNPATH)\)")

    def test_says_the_version_that_the_command_line_says(self):
        (version,) = re.findall(r"project\(\w+ VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())
        said = subprocess.run([TOOL, "--version"], check=True, capture_output=True, text=True).stdout.strip()
        self.assertEqual(said, version)
        self.assertIn(f"Version {version} of the plugin.".encode(), PLUGIN.read_bytes())


if __name__ == "__main__":
    unittest.main()
