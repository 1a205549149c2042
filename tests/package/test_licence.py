# SPDX-License-Identifier: GPL-3.0-or-later
"""Every source file, header, script and CMake file names its licence in its first line, or in the second after #!."""

import os
import pathlib
import unittest

SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
IDENTIFIER = "SPDX-License-Identifier: GPL-3.0-or-later"
COMMENTS = {".cpp": "//", ".h": "//", ".py": "#", ".pyi": "#", ".cmake": "#", ".in": "#", ".map": "#"}
NOT_OURS = {"build", "dist"}


def files(folder):
    for path in sorted(folder.iterdir()):
        if path.is_dir():
            if path.name not in NOT_OURS and (path.name == ".ci" or not path.name.startswith((".", "__pycache__"))):
                yield from files(path)
        else:
            yield path


def comment_of(path):
    """What begins a comment in it, or nothing where it is no source."""
    if path.name == "CMakeLists.txt" or path.parent in (SOURCE / "scripts", SOURCE / ".ci") and not path.suffix:
        return "#"
    return COMMENTS.get(path.suffix)


def licensed(text, comment):
    lines = text.split("\n", 2)
    return lines[lines[0].startswith("#!")] == f"{comment} {IDENTIFIER}"


class Licence(unittest.TestCase):
    def test_of_every_source_is_named(self):
        sources = [path for path in files(SOURCE) if comment_of(path)]
        folders = {path.relative_to(SOURCE).parts[0] for path in sources}
        self.assertLessEqual({"vcg_core", "filter_anisotropic_smooth", "tools", "python", "tests", "benchmarks", "scripts",
                              "cmake", ".ci", "CMakeLists.txt"}, folders)
        without = [str(path.relative_to(SOURCE)) for path in sources
                   if not licensed(path.read_text(encoding="utf-8"), comment_of(path))]
        self.assertEqual(without, [])

    def test_missing_and_misplaced_names_are_seen(self):
        self.assertTrue(licensed(f"#!/bin/bash\n# {IDENTIFIER}\n", "#"))
        self.assertFalse(licensed("#!/bin/bash\n", "#"))
        self.assertFalse(licensed("", "//"))
        self.assertFalse(licensed(f"#pragma once\n// {IDENTIFIER}\n", "//"))
        self.assertFalse(licensed(f"// {IDENTIFIER}-only\n", "//"))

    def test_is_that_of_the_text(self):
        text = (SOURCE / "LICENSE").read_text(encoding="utf-8")
        self.assertIn("GNU GENERAL PUBLIC LICENSE\n                       Version 3", text)


if __name__ == "__main__":
    unittest.main()
