# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/release as far as it is cheap: what it refuses, names, notes and checksums; and what its plugins and its command
line are linked like, seen on the programs of this build, which are linked a second time."""

import ctypes
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "plugin"))

from description import describe  # noqa: E402

SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
BUILD = pathlib.Path(os.environ["ANISO_BUILD"])
WORK = pathlib.Path(os.environ["ANISO_WORK"])
TOOL = os.environ["ANISO_TOOL"]
CXX = os.environ["ANISO_CXX"]
PLUGIN = os.environ.get("ANISO_PLUGIN")
DESCRIBE = os.environ.get("ANISO_DESCRIBE_PLUGIN")
SYMBOLS = SOURCE / "scripts/symbol_versions"
CAN_RELINK = os.environ["ANISO_GENERATOR"] == "Ninja" and not os.environ["ANISO_SANITIZE"]
IS_GCC = "Free Software Foundation" in subprocess.run([CXX, "--version"], check=True, capture_output=True, text=True).stdout


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", timeout=240, **options)


def succeed(*command, **options):
    done = run(*command, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)


class Release(unittest.TestCase):
    """In a repository of its own, of what the script reads."""

    files = ("scripts/release", "scripts/own_folder", "CMakeLists.txt", "CHANGELOG.md", "LICENSE")

    def setUp(self):
        self.clone = WORK / "clone"
        shutil.rmtree(self.clone, ignore_errors=True)
        for name in self.files:
            (self.clone / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / name, self.clone / name)
        (self.clone / ".gitignore").write_text("build/\n")
        self.git("init", "--quiet")
        self.commit()

    def git(self, *words):
        return succeed("git", "-c", "user.name=test", "-c", "user.email=test@example.org", *words, cwd=self.clone)

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", "test")

    def release(self, *arguments):
        return run(self.clone / "scripts/release", *arguments)

    def made(self):
        folder = self.clone / "build/release"
        return {path.name for path in folder.iterdir() if not path.name.startswith(".")} if folder.exists() else set()

    def test_names_notes_and_checksums_follow_the_version(self):
        lists = self.clone / "CMakeLists.txt"
        lists.write_text(re.sub(r"(project\(\w+ VERSION )[\d.]+", r"\g<1>9.8.7", lists.read_text()))
        (self.clone / "CHANGELOG.md").write_text(
            "# Changelog\n\n## Unreleased\n- later\n\n## 9.8.7\n- this one\n\n## 9.8.6\n- old\n")
        self.commit()
        for _ in range(2):  # it makes its own folder anew
            done = self.release("--only", "source")
            self.assertEqual(done.returncode, 0, done.stdout)
            archive = "anisotropic_smooth-9.8.7-source.tar.gz"
            self.assertEqual(self.made(), {archive, "RELEASE_NOTES.md", "SHA256SUMS"})
            folder = self.clone / "build/release"
            self.assertEqual((folder / "RELEASE_NOTES.md").read_text().split("\n\n", 1),
                             ["# anisotropic_smooth-9.8.7", "- this one\n\n"])
            sums = dict(reversed(line.split()) for line in (folder / "SHA256SUMS").read_text().splitlines())
            self.assertEqual(sums, {name: hashlib.sha256((folder / name).read_bytes()).hexdigest()
                                    for name in (archive, "RELEASE_NOTES.md")})
            with tarfile.open(folder / archive) as source:
                names = {member.name for member in source if member.isfile()}
            self.assertEqual(names, {f"anisotropic_smooth-9.8.7/{name}" for name in (*self.files, ".gitignore")})
            (folder / "stale").touch()

    def test_notes_of_a_version_that_the_changelog_does_not_name_are_what_is_not_released(self):
        (self.clone / "CHANGELOG.md").write_text("# Changelog\n\n## Unreleased\n- new\n\n## 0.0.1\n- old\n")
        self.commit()
        self.assertEqual(self.release("--only", "source").returncode, 0)
        notes = (self.clone / "build/release/RELEASE_NOTES.md").read_text()
        self.assertIn("- new", notes)
        self.assertNotIn("- old", notes)

    def test_a_tree_with_changes_is_refused(self):
        for change in (lambda: (self.clone / "LICENSE").write_text("mine"), lambda: (self.clone / "new.txt").touch()):
            change()
            done = self.release("--only", "source")
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("the tree has changes", done.stdout)
            self.assertEqual(self.made(), set())
            self.commit()
        self.assertEqual(self.release("--only", "source").returncode, 0)

    def test_a_folder_of_somebody_else_is_refused(self):
        letter = self.clone / "build/release/letter"
        letter.parent.mkdir(parents=True)
        letter.write_text("precious")
        done = self.release("--only", "source")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("is not a folder that release has made", done.stdout)
        self.assertEqual(letter.read_text(), "precious")

    def test_wrong_arguments(self):
        for arguments in (("--only", "sources"), ("--only",), ("--all",)):
            self.assertEqual(self.release(*arguments).returncode, 2, arguments)
        self.assertEqual(self.made(), set())


USES_NEWER = """
#include <charconv>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>

extern "C" double answer(const char* number) {
  const std::string text(number);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  std::exception_ptr thrown;
  std::thread([&] {
    try {
      throw std::runtime_error("x");
    } catch (...) {
      thrown = std::current_exception();
    }
  }).join();
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception&) {
    return std::exp(value);
  }
}
"""


def check(path):
    done = run(SYMBOLS, "check", path)
    return done.returncode, done.stdout


@unittest.skipUnless(IS_GCC, "libstdc++'s own compiler is needed")
class SymbolVersions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.older = WORK / "older"
        succeed(SYMBOLS, "--compiler", CXX, "libraries", cls.older)

    def link(self, source, *options):
        path = WORK / "linked.so"
        (WORK / "source.cpp").write_text(source)
        done = run(CXX, "-std=c++17", "-O1", "-fPIC", "-shared", "-o", path, WORK / "source.cpp", "-Wl,--no-undefined",
                   "-Wl,--exclude-libs,ALL", *options)
        return path, done

    def needed(self, path):
        return set(re.findall(r"\(NEEDED\).*\[(.*)\]", succeed("readelf", "-d", path)))

    def test_newer_symbols_are_found_by_name(self):
        path, done = self.link(USES_NEWER)
        self.assertEqual(done.returncode, 0, done.stdout)
        status, output = check(path)
        self.assertEqual(status, 1)
        self.assertRegex(output, r"needs \w*from_chars\w*@GLIBCXX_3\.4\.")

    def test_linked_with_the_older_libraries_there_are_none_and_it_runs(self):
        path, done = self.link(USES_NEWER, f"-L{self.older}")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(check(path), (0, ""))
        self.assertIn("libstdc++.so.6", self.needed(path))  # one run-time library for both sides
        library = ctypes.CDLL(str(path))
        library.answer.restype = ctypes.c_double
        self.assertAlmostEqual(library.answer(b"0.5"), 1.6487212707001282, places=15)

    def test_what_has_no_older_form_does_not_link(self):
        source = '#include <unistd.h>\nextern "C" int id() { return gettid(); }\n'  # since glibc 2.30
        path, done = self.link(source)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("gettid@GLIBC_2.30", check(path)[1])
        _, done = self.link(source, f"-L{self.older}")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("undefined reference to `gettid'", done.stdout)

    @unittest.skipUnless(PLUGIN, "needs MeshLab's library")
    def test_a_library_of_names_needs_nothing(self):
        library = os.environ["ANISO_MESHLAB_LIBRARY"]
        version = (pathlib.Path(os.environ["ANISO_MESHLAB_SOURCE"]) / "ML_VERSION").read_text().strip()
        names = WORK / "names/libmeshlab-common.so"
        succeed(SYMBOLS, "--compiler", CXX, "names", library, version, names)
        self.assertEqual(self.needed(names), set())
        self.assertIn("libmeshlab-common.so", re.findall(r"SONAME.*\[(.*)\]", succeed("readelf", "-d", names)))

        def defined(path):
            return {line.split()[-1].split("@")[0] for line in succeed("nm", "-D", "--defined-only", path).splitlines()}

        self.assertEqual(defined(names), defined(library))
        self.assertIn(version.encode(), names.read_bytes())
        self.assertIn("does not hold the version", run(SYMBOLS, "names", library, "1999.12", WORK / "none.so").stdout)
        self.assertFalse((WORK / "none.so").exists())

    @unittest.skipUnless(CAN_RELINK and PLUGIN and DESCRIBE, "needs Ninja, the plugin, and no sanitizers")
    def test_the_plugin_needs_none_and_has_the_same_filters(self):
        path = relinked(PLUGIN, "filter_anisotropic_smooth", f"-L{self.older}")
        self.assertEqual(check(path), (0, ""))
        self.assertIn("libstdc++.so.6", self.needed(path))
        visible = succeed("nm", "-D", "--defined-only", path)
        self.assertEqual({line.split()[-1] for line in visible.splitlines()},
                         {"qt_plugin_instance", "qt_plugin_query_metadata"})
        self.assertEqual(describe(DESCRIBE, PLUGIN), describe(DESCRIBE, path))


def relinked(path, target, option):
    """The program or plugin at `path` linked again, with one more option."""
    build = pathlib.Path(path).parent.parent
    command = succeed("ninja", "-C", build, "-t", "commands", target).splitlines()[-1]
    name = str(pathlib.Path(path).relative_to(build))
    output = WORK / pathlib.Path(path).name
    if command.count(f" -o {name} ") != 1:
        raise AssertionError(f"no link of {name} in: {command}")
    succeed("bash", "-euc", command.replace(f" -o {name} ", f" {option} -o {output} "), cwd=build)
    return output


@unittest.skipUnless(CAN_RELINK, "needs Ninja, and no sanitizers")
class CommandLine(unittest.TestCase):
    @unittest.skipIf(os.geteuid(), "needs root, for chroot")
    def test_runs_where_there_is_nothing_else(self):
        """No library, no locale, no /proc, no /dev: threads, exceptions and numbers work, and results are the same bytes."""
        program = relinked(TOOL, "anisosmooth", "-static")
        root = WORK / "root"
        root.mkdir()
        shutil.copy(program, root / "anisosmooth")

        def both(*arguments):
            outside = run(TOOL, *arguments, cwd=WORK, env={})
            inside = run("chroot", root, "/anisosmooth", *arguments, env={"LC_ALL": "de_DE.UTF-8", "PATH": os.environ["PATH"]})
            return outside, inside

        for arguments in (("generate", "cad_part", "clean.ply", "--vertices", "3000"),
                          ("noise", "clean.ply", "noisy.ply", "--level", "0.2"),
                          ("smooth", "noisy.ply", "paper.ply", "--threads", "4", "--method", "paper", "--sigma-c", "2.5"),
                          ("smooth", "noisy.ply", "guided.obj", "--method", "guided", "--report", "report.json", "--quiet"),
                          ("measure", "paper.ply", "clean.ply")):
            outside, inside = both(*arguments)
            self.assertEqual((outside.returncode, inside.returncode), (0, 0), inside.stdout)
        for name in ("clean.ply", "noisy.ply", "paper.ply", "guided.obj"):
            self.assertEqual((WORK / name).read_bytes(), (root / name).read_bytes(), name)
        for arguments in (("smooth", "none.ply", "out.ply"), ("smooth", "noisy.ply", "out.ply", "--sigma-c", "-1")):
            outside, inside = both(*arguments)
            self.assertEqual((outside.returncode, outside.stdout), (inside.returncode, inside.stdout))
            self.assertEqual(inside.returncode, 1)
        self.assertFalse((root / "out.ply").exists())


if __name__ == "__main__":
    unittest.main()
