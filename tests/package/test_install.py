# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the plugin in all the ways that README.md names, and takes it away again."""

import os
import pathlib
import shutil
import subprocess
import unittest

import clean_root

CMAKE = os.environ["ANISO_CMAKE"]
BUILD = pathlib.Path(os.environ["ANISO_BUILD"])
SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
WORK = pathlib.Path(os.environ["ANISO_WORK"])
TOOL = os.environ["ANISO_TOOL"]
LIBRARY = pathlib.Path(os.environ["ANISO_MESHLAB_LIBRARY"])
PLUGIN = pathlib.Path(os.environ["ANISO_PLUGIN"])
APPLY_MLX = os.environ.get("ANISO_APPLY_MLX")  # built for MeshLab since 2021 only
VERSION = (pathlib.Path(os.environ["ANISO_MESHLAB_SOURCE"]) / "ML_VERSION").read_text().strip()
# Below /usr or another prefix.
INSTALLED = {f"{LIBRARY.parent.relative_to('/usr')}/plugins/{PLUGIN.name}", *(["bin/apply_mlx"] if APPLY_MLX else [])}
FILTER = "Anisotropic Feature-Preserving Smoothing"


def run(*command, **environment):
    return subprocess.run([str(word) for word in command], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=120, env={**os.environ, **environment})


def succeed(*command, **environment):
    done = run(*command, **environment)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def files(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if not path.is_dir()}


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)


class Install(unittest.TestCase):
    def test_below_a_prefix_as_below_usr_and_away_by_the_manifest(self):
        prefix = WORK / "prefix"
        succeed(CMAKE, "--install", BUILD, "--component", "plugin", "--prefix", prefix)
        self.assertEqual(files(prefix), INSTALLED)
        succeed("bash", "-euc", 'xargs rm <"$0/install_manifest_plugin.txt"', BUILD)
        self.assertEqual(files(prefix), set())

    def test_in_the_users_own_folder(self):
        stage = WORK / "stage"
        if not APPLY_MLX:
            done = run(CMAKE, "--install", BUILD, "--component", "user_plugin", DESTDIR=str(stage))
            self.assertIn(f"MeshLab {VERSION} reads no plugins of a user's own", " ".join(done.stdout.split()))
            self.assertNotEqual(done.returncode, 0)
            return
        succeed(CMAKE, "--install", BUILD, "--component", "user_plugin", DESTDIR=str(stage))
        self.assertEqual([path.split("VCG/")[1] for path in files(stage)],
                         [f"MeshLab_64bit_fp/MeshLabExtraPlugins/{VERSION}/{PLUGIN.name}"])


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        succeed("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", WORK / "packages")
        (cls.package,) = (WORK / "packages").glob("*.deb")
        cls.mesh = WORK / "noisy.ply"
        succeed(TOOL, "generate", "sphere", cls.mesh, "--vertices", "1000")

    def test_fields_and_files(self):
        installed = succeed("dpkg-query", "-W", "-f", "${Version}", "meshlab")
        self.assertEqual(succeed("dpkg-deb", "-f", self.package, "Package", "Depends").splitlines(),
                         ["Package: meshlab-filter-anisotropic-smooth", f"Depends: meshlab (= {installed})"])
        succeed("dpkg-deb", "-x", self.package, WORK / "unpacked")
        self.assertEqual(files(WORK / "unpacked/usr"), INSTALLED)
        self.assertEqual({path.name for path in (WORK / "unpacked").iterdir()}, {"usr"})

    @unittest.skipUnless(clean_root.is_possible(), "needs root, to mount an overlay over /")
    def test_filter_appears_and_goes(self):
        """MeshLab itself, or apply_mlx which loads MeshLab's own folder of plugins, smooths only while the package is
        there."""
        result = WORK / "smooth.ply"
        script = SOURCE / "scripts/demo.mlx"
        arguments = f"-i '{self.mesh}' -o '{result}' -s '{script}'"
        if APPLY_MLX:
            smooth = f"'{APPLY_MLX}' {arguments}"
        else:
            smooth = f"xvfb-run -a -s '-screen 0 1400x900x24 +extension GLX' meshlabserver {arguments}"
        for name, commands, appears in (("without", "", False), ("with", f"dpkg -i '{self.package}'", True),
                                        ("after", f"dpkg -i '{self.package}'; dpkg -r meshlab-filter-anisotropic-smooth",
                                         False)):
            with self.subTest(name):
                result.unlink(missing_ok=True)
                status, output = clean_root.run(f"{commands}\n{smooth}", SOURCE, WORK / "overlay")
                self.assertEqual(result.exists(), appears, output)
                self.assertEqual(status == 0, appears, output)
                self.assertIn("moved 1000 of 1000 vertices" if appears else FILTER, output)


if __name__ == "__main__":
    unittest.main()
