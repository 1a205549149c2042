# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs README.md's examples exactly as they are printed there: the script inside meshlabserver, the commands, and the
library example as a project of its own against the installed package."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "plugin"))

import ply  # noqa: E402
from environment import LIBRARY, PLUGIN, SOURCE, TOOL, Display, PrivateMeshLab, fresh_work_folder, run_tool  # noqa: E402


def example(mark):
    """The code block that follows the comment <!-- mark -->."""
    text = (SOURCE / "README.md").read_text(encoding="utf-8")
    found = re.findall(rf"<!-- {re.escape(mark)} -->\n```\w+\n(.*?)```", text, re.DOTALL)
    if len(found) != 1:
        raise AssertionError(f"README.md has {len(found)} examples marked '{mark}'")
    return found[0]


def run(command, **options):
    done = subprocess.run(command, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", timeout=240, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def setUpModule():
    global work
    work = fresh_work_folder()


class CommandLine(unittest.TestCase):
    def test_commands(self):
        folder = work / "command_line"
        folder.mkdir()
        path = f"{TOOL.parent}:{os.environ['PATH']}"
        printed = run(["bash", "-e", "-c", example("run: command line")], cwd=folder, env={**os.environ, "PATH": path})
        self.assertIn("face normal error", printed)
        self.assertEqual({file.name for file in folder.iterdir()},
                         {"clean.ply", "noisy.ply", "smooth.ply", "report.json", "distance.ply", "smoothed"})


@unittest.skipIf(PLUGIN is None, "built without the plugin")
class Script(unittest.TestCase):
    def test_script(self):
        folder = work / "script"
        folder.mkdir()
        meshlab = PrivateMeshLab(folder)
        run_tool("generate", "cad_part", folder / "clean.ply", "--vertices", 3000)
        run_tool("noise", folder / "clean.ply", folder / "noisy.ply", "--level", "0.2")
        (folder / "smooth.mlx").write_text(example("file: smooth.mlx"))
        with Display() as display:
            environment = meshlab.environment(display.name)
            environment["PATH"] = f"{meshlab.prefix}/bin:{environment['PATH']}"
            run(["bash", "-e", "-c", example("run: script")], cwd=folder, env=environment)
        run_tool("smooth", folder / "noisy.ply", folder / "by_tool.ply")
        self.assertEqual(ply.positions(folder / "smooth.ply"), ply.positions(folder / "by_tool.ply"))

    def test_the_demo_uses_the_same_script(self):
        self.assertEqual(example("file: smooth.mlx"), (SOURCE / "scripts/demo.mlx").read_text())


class Library(unittest.TestCase):
    def test_installed_package_in_another_project(self):
        prefix, project = work / "installed", work / "project"
        cmake = os.environ["ANISO_CMAKE"]
        run([cmake, "--install", os.environ["ANISO_BUILD"], "--prefix", prefix])
        self.assertTrue((prefix / "bin" / TOOL.name).exists())
        if PLUGIN is not None:
            self.assertTrue((prefix / LIBRARY.parent.relative_to("/usr") / "plugins" / PLUGIN.name).exists())

        project.mkdir()
        for name in ("main.cpp", "CMakeLists.txt"):
            (project / name).write_text(example(f"file: {name}"))
        flags = f"-fsanitize={os.environ['ANISO_SANITIZE']}" if os.environ["ANISO_SANITIZE"] else ""
        run([cmake, "-S", project, "-B", project / "build", "-G", os.environ["ANISO_GENERATOR"],
             f"-DCMAKE_PREFIX_PATH={prefix}",
             f"-DVCGLIB_DIR={os.environ['ANISO_VCGLIB']}", f"-DCMAKE_CXX_COMPILER={os.environ['ANISO_CXX']}",
             f"-DCMAKE_CXX_FLAGS={flags}"])
        run([cmake, "--build", project / "build"])

        run_tool("generate", "sphere", work / "clean.off", "--vertices", 1000)
        run_tool("noise", work / "clean.off", work / "noisy.off", "--level", "0.2")
        printed = run([project / "build/my_smoother", work / "noisy.off", work / "smooth.off"])
        self.assertEqual(printed, "moved 1000 of 1000 vertices\n")

        run_tool("smooth", work / "noisy.off", work / "by_tool.off", "--sigma-n", "0.2")
        ours, theirs = ([float(word) for line in (work / name).read_text().splitlines()[2:1002] for word in line.split()]
                        for name in ("smooth.off", "by_tool.off"))
        self.assertEqual(len(ours), 3000)
        # vcglib's exporter prints fewer digits than ours.
        self.assertLess(max(abs(a - b) for a, b in zip(ours, theirs)), 1e-5)


if __name__ == "__main__":
    unittest.main()
