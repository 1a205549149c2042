#!/usr/bin/env python3
"""same_results.py FOLDER FOLDER...: whether the tests by script have left the same in all folders, one per MeshLab.

Every mesh that a filter of MeshLab has smoothed (*_server.ply) must have the same vertices, bit for bit, in all of them, and
so must the meshes that went in."""

import pathlib
import sys

import ply


def main():
    folders = [pathlib.Path(name) for name in sys.argv[1:]]
    names = sorted(path.name for path in folders[0].glob("*_server.ply")) + ["cad_part_noisy.ply", "thin_sheets_noisy.ply"]
    if len(names) < 3:
        sys.exit(f"same_results: {folders[0]} holds no results; run the tests there first")
    different = [f"{folder / name}" for name in names for folder in folders[1:]
                 if not (folder / name).exists() or ply.positions(folder / name) != ply.positions(folders[0] / name)]
    if different:
        sys.exit("same_results: other vertices than in {}: {}".format(folders[0], ", ".join(different)))
    print(f"same_results: {len(names)} meshes are the same, bit for bit, in {', '.join(map(str, folders))}")


if __name__ == "__main__":
    main()
