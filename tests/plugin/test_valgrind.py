# SPDX-License-Identifier: GPL-3.0-or-later
"""Every filter in MeshLab's own meshlabserver under valgrind: no invalid access, nothing read that was never written, no
memory lost, as far as our library is among the callers. What MeshLab and its libraries do alone is not looked at."""

import re
import shutil
import subprocess
import unittest

import scripts
from environment import Display, PrivateMeshLab, fresh_work_folder, run_tool


@unittest.skipIf(shutil.which("valgrind") is None, "needs valgrind")
class Valgrind(unittest.TestCase):
    def test_every_filter(self):
        work = fresh_work_folder()
        meshlab = PrivateMeshLab(work)
        run_tool("generate", "thin_sheets", work / "clean.ply", "--vertices", 600)
        run_tool("noise", work / "clean.ply", work / "noisy.ply", "--level", "0.2")
        log = work / "memcheck.log"
        script = scripts.write(work / "script.mlx", *scripts.DEFAULTS)
        with Display() as display:
            done = subprocess.run(
                ["valgrind", "--leak-check=full", "--keep-debuginfo=yes", "--num-callers=40", f"--log-file={log}",
                 meshlab.prefix / "bin/meshlabserver", "-i", work / "noisy.ply", "-o", work / "out.ply", "-s", script],
                env=meshlab.environment(display.name), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                errors="replace", check=False, timeout=1200)
        self.assertEqual(done.returncode, 0, done.stdout)
        for name in scripts.DEFAULTS:
            self.assertIn(name, done.stdout)
        text = log.read_text()
        self.assertIn("ERROR SUMMARY", text)
        findings = re.split(r"\n==\d+== \n", text)
        self.assertEqual([found for found in findings if "libfilter_anisotropic_smooth" in found], [])


if __name__ == "__main__":
    unittest.main()
