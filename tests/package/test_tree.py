# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the plugin inside MeshLab's own source tree and, against the double-precision library that comes out of it, from
outside: the same CMakeLists.txt. MeshLab's other plugins are left out, but for the reader of meshes.

MeshLab 2022.02 is laid out as meshlab-extra-plugins and built with floats; later ones get the plugin into their
src/meshlabplugins and are built with doubles. What compiling takes is paid once: scripts/in_root keeps a compiler cache."""

import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "plugin"))

import ply  # noqa: E402
from description import describe  # noqa: E402

CMAKE = os.environ["ANISO_CMAKE"]
SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
MESHLAB = pathlib.Path(os.environ["ANISO_MESHLAB_SOURCE"])
WORK = pathlib.Path(os.environ["ANISO_WORK"])
TOOL = os.environ["ANISO_TOOL"]
NAME = "filter_anisotropic_smooth"
PLUGIN = f"lib{NAME}.so"
VERSION = (MESHLAB / "ML_VERSION").read_text().strip()
IN_EXTRA_PLUGINS = VERSION == "2022.02"
FOLDERS = ("cmake", "vcg_core", NAME)

# What Debian's own build tells MeshLab as well: it has no copies of these libraries.
SYSTEM_LIBRARIES = ("-DEIGEN3_INCLUDE_DIR=/usr/include/eigen3", "-DGLEW_VERSION=2.2.0")
WITHOUT_OPTIONAL = {name: "OFF" for name in ("MESHLAB_ALLOW_OPTIONAL_EXTERNAL_LIBRARIES",
                                             "ALLOW_OPTIONAL_EXTERNAL_MESHLAB_LIBRARIES")}

# Imported targets live in the folder that asks for them: the plugin needs them from the top.
EXTRA_PLUGINS = """
cmake_minimum_required(VERSION 3.18)
project(layout_of_meshlab_extra_plugins)
find_package(OpenGL REQUIRED)
find_package(Qt5 REQUIRED COMPONENTS OpenGL Xml Network)
find_package(GLEW REQUIRED)
set(MESHLAB_PLUGINS meshlabplugins/io_base)
set(BUILD_ONLY_MESHLAB_LIBRARIES ON)
add_subdirectory(meshlab/src)
add_subdirectory(plugins/filter_anisotropic_smooth)
"""


def run(*command, timeout=3000):
    done = subprocess.run([str(word) for word in command], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", timeout=timeout)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout[-6000:]}")
    return done.stdout


def launcher():
    return ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []


def configure(source, build, *definitions):
    return run(CMAKE, "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *launcher(), *definitions)


def build(folder, *targets):
    run(CMAKE, "--build", folder, "--target", *targets)


def drop_into(folder):
    """This project as a user would copy it, without what only its own build needs."""
    folder.mkdir(parents=True)
    shutil.copy(SOURCE / "CMakeLists.txt", folder)
    for name in FOLDERS:
        shutil.copytree(SOURCE / name, folder / name)


def built(folder, name):
    (path,) = folder.rglob(name)
    return path


def coordinates(path):
    return [struct.unpack("<d" if len(value) == 8 else "<f", value)[0]
            for position in ply.positions(path) for value in position]


def setUpModule():
    """Builds MeshLab's library, its reader of meshes and our plugin; then, from outside, what asks and applies it."""
    global library, inside, outside, printed
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    tree = WORK / "tree"
    definitions = [*SYSTEM_LIBRARIES, *(f"-D{name}={value}" for name, value in WITHOUT_OPTIONAL.items())]
    shutil.copytree(MESHLAB, tree / "meshlab", symlinks=True)
    if IN_EXTRA_PLUGINS:
        drop_into(tree / "plugins" / NAME)
        (tree / "CMakeLists.txt").write_text(EXTRA_PLUGINS)
        top = tree
    else:
        drop_into(tree / "meshlab/src/meshlabplugins" / NAME)
        top = tree / "meshlab"
        definitions += ["-DMESHLAB_BUILD_WITH_DOUBLE_SCALAR=ON", "-DMESHLAB_BUILD_ONLY_LIBRARIES=ON",
                        f"-DMESHLAB_PLUGINS=meshlabplugins/io_base;meshlabplugins/{NAME}"]
    printed = configure(top, WORK / "inside", *definitions)
    build(WORK / "inside", "io_base", NAME)
    library = built(WORK / "inside", "libmeshlab-common.so")
    inside = built(WORK / "inside", PLUGIN)

    printed += configure(SOURCE, WORK / "outside", f"-DMESHLAB_SOURCE_DIR={MESHLAB}", f"-DMESHLAB_LIBRARY={library}")
    build(WORK / "outside", NAME, "apply_mlx", "describe_plugin")
    outside = built(WORK / "outside", PLUGIN)


class Tree(unittest.TestCase):
    maxDiff = None

    def test_the_plugin_lies_beside_meshlabs_own(self):
        self.assertEqual(inside.parent, built(WORK / "inside", "libio_base.so").parent)

    def test_precision_is_found_out(self):
        scalar = "float" if IN_EXTRA_PLUGINS else "double"
        self.assertIn(f"Plugin for MeshLab {VERSION} ({scalar}), loaded from {library.parent}/plugins", printed)

    def test_filters_are_as_released(self):
        released = json.loads((SOURCE / "tests/plugin/filters.json").read_text())
        for plugin in (inside, outside):
            with self.subTest(plugin=plugin):
                self.assertEqual(describe(built(WORK / "outside", "describe_plugin"), plugin), released)

    def test_results_are_the_command_lines(self):
        """The plugin that MeshLab's build has left beside MeshLab's own, then ours, installed over it."""
        clean, noisy, by_tool, smooth = (WORK / f"{name}.ply" for name in ("clean", "noisy", "by_tool", "smooth"))
        run(TOOL, "generate", "cad_part", clean, "--vertices", "3000")
        run(TOOL, "noise", clean, noisy, "--level", "0.2")
        run(TOOL, "smooth", noisy, by_tool)
        expected = coordinates(by_tool)
        for built_from in ("inside", "outside"):
            with self.subTest(built_from):
                if built_from == "outside":
                    run(CMAKE, "--install", WORK / "outside", "--component", "plugin", "--prefix", WORK / "prefix")
                smooth.unlink(missing_ok=True)
                run(built(WORK / "outside/bin", "apply_mlx"), "-i", noisy, "-o", smooth, "-s", SOURCE / "scripts/demo.mlx")
                found = coordinates(smooth)
                self.assertEqual(len(found), len(expected))
                # A last bit of a float where the double's value lies between two; the part's size is about 1.
                self.assertLess(max(abs(a - b) for a, b in zip(found, expected)), 1e-6)


if __name__ == "__main__":
    unittest.main()
