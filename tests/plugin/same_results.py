#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""same_results.py FOLDER FOLDER...: whether the tests by script have left the same in all folders, one per MeshLab.

Bit for bit: each MeshLab comes with its own compiler, and the same input gives the same result by all of them."""

import pathlib
import sys

import ply


def main():
    folders = [pathlib.Path(name) for name in sys.argv[1:]]
    inputs = ["cad_part_noisy.ply", "thin_sheets_noisy.ply"]
    results = sorted(path.name for path in folders[0].glob("*_server.ply"))
    if not results:
        sys.exit(f"same_results: {folders[0]} holds no results; run the tests there first")
    for folder in folders[1:]:
        bad = [name for name in inputs + results if ply.positions(folders[0] / name) != ply.positions(folder / name)]
        if bad:
            sys.exit(f"same_results: {folder} and {folders[0]} differ in {', '.join(bad)}")
        print(f"same_results: {folder}: {len(inputs + results)} meshes are those of {folders[0]} bit for bit")


if __name__ == "__main__":
    main()
