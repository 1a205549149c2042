# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of MeshLab's sources and library that do not belong together: configuring stops with a sentence that helps.

Libraries of other MeshLabs are copies of the installed one in which the texts that tell version and precision differ;
where scripts/meshlab_root has made its root folders, the real ones take part as well."""

import itertools
import os
import pathlib
import shutil
import subprocess
import unittest

CMAKE = os.environ["ANISO_CMAKE"]
SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
LIBRARY = pathlib.Path(os.environ["ANISO_MESHLAB_LIBRARY"])
MESHLAB = pathlib.Path(os.environ["ANISO_MESHLAB_SOURCE"])
WORK = pathlib.Path(os.environ["ANISO_WORK"])
ROOTS = pathlib.Path(os.environ.get("ANISO_ROOTS") or
                     pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") /
                     "anisotropic_smooth/roots")


def own_version():
    return (MESHLAB / "ML_VERSION").read_text().strip()


def library(version, scalar):
    """A copy of the installed library that says it is another one; no byte moves."""
    content = LIBRARY.read_bytes()
    kind = b"setMeshTransformationMatrixEiRKN3vcg8Matrix44I%cEE"
    for text in (b"\0" + own_version().encode() + b"\0", kind % b"f"):
        if text not in content:
            raise AssertionError(f"{LIBRARY} does not hold {text}")
    content = content.replace(b"\0" + own_version().encode() + b"\0", b"\0" + version.encode() + b"\0")
    content = content.replace(kind % b"f", kind % scalar[:1].encode())
    path = WORK / f"libmeshlab-common-{version}-{scalar}.so"
    path.write_bytes(content)
    return path


def sources(version):
    """The source tree of the installed MeshLab that says it is another one."""
    folder = WORK / f"sources-{version}"
    if not folder.exists():
        folder.mkdir()
        for entry in MESHLAB.iterdir():
            (folder / entry.name).symlink_to(entry)
        (folder / "ML_VERSION").unlink()
        (folder / "ML_VERSION").write_text(version)
    return folder


def configure(*definitions):
    """Status and output, in one line, of configuring the project without tools and tests. Only what is known of the
    compiler and of Qt is kept from one call to the next."""
    done = subprocess.run([CMAKE, "-S", SOURCE, "-B", WORK / "build", "-G", os.environ["ANISO_GENERATOR"],
                           "-UMESHLAB_*", "-UVCGLIB_DIR", "-UANISO_PLUGIN_INSTALL_DIR",
                           f"-DCMAKE_CXX_COMPILER={os.environ['ANISO_CXX']}", "-DANISO_BUILD_TESTS=OFF",
                           "-DANISO_BUILD_TOOLS=OFF", *(f"-D{definition}" for definition in definitions)],
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
    return done.returncode, " ".join(done.stdout.split())


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)


class Pairing(unittest.TestCase):
    def refused(self, sentence, *definitions):
        status, output = configure(*definitions)
        self.assertIn(sentence, output)
        self.assertNotEqual(status, 0, output)

    def test_a_pair_that_fits_is_named(self):
        status, output = configure(f"MESHLAB_SOURCE_DIR={MESHLAB}", f"MESHLAB_LIBRARY={LIBRARY}")
        self.assertEqual(status, 0, output)
        self.assertIn(f"Plugin for MeshLab {own_version()} (float), loaded from {LIBRARY.parent}/plugins", output)

    def test_sources_of_one_version_and_library_of_another(self):
        for ours, theirs in itertools.permutations(("2020.09", "2022.02", "2025.07"), 2):
            with self.subTest(sources=ours, library=theirs):
                path = library(theirs, "float")
                self.refused(f"are MeshLab {ours}'s, but {path} is MeshLab {theirs}'s: a plugin of this pair would not "
                             "load.", f"MESHLAB_SOURCE_DIR={sources(ours)}", f"MESHLAB_LIBRARY={path}")

    def test_double_precision_wanted_of_a_library_of_floats(self):
        self.refused(f"MESHLAB_SCALAR is double, but {LIBRARY} was built with float: that MeshLab would refuse the plugin. "
                     "Give -DMESHLAB_SCALAR=float", f"MESHLAB_SOURCE_DIR={MESHLAB}", f"MESHLAB_LIBRARY={LIBRARY}",
                     "MESHLAB_SCALAR=double")

    def test_floats_wanted_of_a_library_of_double_precision(self):
        path = library(own_version(), "double")
        self.refused(f"MESHLAB_SCALAR is float, but {path} was built with double", f"MESHLAB_SOURCE_DIR={MESHLAB}",
                     f"MESHLAB_LIBRARY={path}", "MESHLAB_SCALAR=float")

    def test_precision_is_the_librarys_own(self):
        path = library(own_version(), "double")
        status, output = configure(f"MESHLAB_SOURCE_DIR={MESHLAB}", f"MESHLAB_LIBRARY={path}")
        self.assertEqual(status, 0, output)
        self.assertIn(f"Plugin for MeshLab {own_version()} (double)", output)

    def test_a_precision_that_does_not_exist(self):
        self.refused("MESHLAB_SCALAR is half; it must be float or double", f"MESHLAB_SOURCE_DIR={MESHLAB}",
                     f"MESHLAB_LIBRARY={LIBRARY}", "MESHLAB_SCALAR=half")

    def test_vcglib_of_another_meshlab(self):
        own = next(path for path in (MESHLAB / "vcglib", MESHLAB / "src/vcglib") if path.exists())
        other = WORK / "other_vcglib"
        shutil.copytree(own / "vcg/complex", other / "vcg/complex")
        self.refused(f"vcglib is taken from {other}, but the MeshLab that loads the plugin was built with the one in",
                     f"MESHLAB_SOURCE_DIR={MESHLAB}", f"MESHLAB_LIBRARY={LIBRARY}", f"VCGLIB_DIR={other}")

    def test_real_meshlabs_of_other_releases(self):
        installed = {own_version(): (MESHLAB, LIBRARY)}
        for root in sorted(ROOTS.glob("*/usr/src/meshlab")):
            path = next(root.parents[2].glob("usr/lib/*/meshlab/libmeshlab-common.so"), None)
            if (root / "ML_VERSION").exists() and path:
                installed[(root / "ML_VERSION").read_text().strip()] = (root, path)
        if len(installed) == 1:
            self.skipTest(f"there is no root folder in {ROOTS}")
        for (ours, (tree, _)), (theirs, (_, path)) in itertools.permutations(installed.items(), 2):
            with self.subTest(sources=ours, library=theirs):
                self.refused(f"are MeshLab {ours}'s, but {path} is MeshLab {theirs}'s", f"MESHLAB_SOURCE_DIR={tree}",
                             f"MESHLAB_LIBRARY={path}")


if __name__ == "__main__":
    unittest.main()
