#!/usr/bin/env python3
"""same_results.py FOLDER FOLDER...: whether the tests by script have left the same in all folders, one per MeshLab.

What went in must be the same bit for bit; what a filter has made of it (*_server.ply) up to the last bits of a float, which
differ between compilers. In each MeshLab by itself the command line of the same build gives the same bits: the tests say."""

import pathlib
import sys

import ply

ROUNDING = 1e-6  # the meshes have sizes of about 1


def largest_difference(one, other):
    first, second = ply.positions(one), ply.positions(other)
    if len(first) != len(second):
        return float("inf")
    return max(abs(a - b) for p, q in zip(first, second) if p != q for a, b in zip(ply.floats(p), ply.floats(q))) \
        if first != second else 0


def main():
    folders = [pathlib.Path(name) for name in sys.argv[1:]]
    inputs = ["cad_part_noisy.ply", "thin_sheets_noisy.ply"]
    results = sorted(path.name for path in folders[0].glob("*_server.ply"))
    if not results:
        sys.exit(f"same_results: {folders[0]} holds no results; run the tests there first")
    for folder in folders[1:]:
        differences = {name: largest_difference(folders[0] / name, folder / name) for name in inputs + results}
        bad = [name for name, largest in differences.items() if largest > (0 if name in inputs else ROUNDING)]
        if bad:
            sys.exit(f"same_results: {folder} and {folders[0]} differ in {', '.join(bad)}")
        same = sum(largest == 0 for largest in differences.values())
        print(f"same_results: {folder}: {same} of {len(differences)} meshes are those of {folders[0]} bit for bit, the others"
              f" up to {max(differences.values()):.1e}")


if __name__ == "__main__":
    main()
