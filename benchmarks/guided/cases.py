# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of the benchmark of the guided filter: shapes, their noise, and groups of them."""

import re
from collections import namedtuple

from .runs import DATA

CAD = ("cad_part", "stepped_block", "cube")
THIN = ("thin_plate", "thin_sheets")
SMOOTH = ("sphere", "torus")
UNEVEN = ("graded_cube", "SharpSphere0.3")
SCANS = ("Bunny0.2",)
PUBLIC = ("Block0.4", "Bunny0.2", "Fandisk0.3", "SharpSphere0.3")
VOXELS = ("voxel_sphere", "voxel_torus", "voxel_cad_part")
SLICES = (1, 3, 6)

# Noise of `level` |e|, in `direction`: along normals, any, or "given" by a pair of files, or of voxels. `correlation` is a
# length in |e|; `slices` is the distance of the slices of voxels, 0 without voxels.
Case = namedtuple("Case", "shape level direction correlation slices", defaults=(0, 0))


def given(model):
    """A pair of files; the number at the end of its name is the noise, where there is one."""
    level = re.search(r"[0-9]+[.][0-9]+$", model)
    return Case(model, float(level.group()) if level else 0, "given")


def is_there(model):
    return any((DATA / model / f"noisy.{kind}").exists() for kind in ("obj", "ply"))


def base_cases():
    """What the benchmark began with: white noise, and the pairs of files. All means are over these."""
    cases = [Case(s, l, "normal") for s in (*CAD, *THIN, *SMOOTH, "graded_cube") for l in (0.1, 0.2, 0.3)]
    cases += [Case(s, l, "any") for s in ("cube", "cad_part", "torus") for l in (0.2, 0.3)]
    cases += [Case(s, 0.5, "normal") for s in ("cad_part", "cube", "sphere")]
    cases += [given(model) for model in PUBLIC if is_there(model)]
    return cases


def further_cases():
    """Noise as scanners and label maps have it, and other pairs of files, with figures of their own."""
    cases = [Case(s, 0.2, "normal", correlation=c) for s in (*CAD, *SMOOTH) for c in (1, 2, 3)]
    cases += [Case(s, 0, "voxels", slices=d) for s in VOXELS for d in SLICES]
    models = sorted(DATA.iterdir()) if DATA.is_dir() else []
    cases += [given(m.name) for m in models if m.name not in PUBLIC and is_there(m.name)]
    return cases


def final_cases():
    """Levels, correlations and slices that nothing was chosen by; to be looked at once."""
    shapes = (*CAD, *THIN, *SMOOTH, "graded_cube")
    cases = [Case(s, l, "normal") for s in shapes for l in (0.15, 0.25, 0.35)]
    cases += [Case(s, 0.25, "any") for s in shapes]
    cases += [Case(s, 0.25, "normal", correlation=1.5) for s in shapes]
    return cases + [Case(s, 0, "voxels", slices=d) for s in VOXELS for d in (1, 2, 4)]


def title(case):
    name = case.shape.replace("_", " ")
    if case.slices:
        return name + (f", slices {case.slices} apart" if case.slices > 1 else "")
    if case.direction == "given":
        return name
    return (f"{name}, {case.level}" + (", any direction" if case.direction == "any" else "") +
            (f", correlated over {case.correlation}" if case.correlation else ""))


def is_base(case):
    return not case.correlation and not case.slices and (case.direction != "given" or case.shape in PUBLIC)


# Groups of cases, by what a case must be.
GROUPS = {
    "CAD": lambda c: is_base(c) and c.shape in (*CAD, "Fandisk0.3", "Block0.4") and c.direction != "any"
    and c.level < 0.5,
    "thin": lambda c: c.shape in THIN,
    "smooth": lambda c: is_base(c) and c.shape in SMOOTH and c.direction == "normal" and c.level < 0.5,
    "uneven": lambda c: c.shape in UNEVEN,
    "scan": lambda c: c.shape in SCANS,
    "any direction": lambda c: c.direction == "any",
    "strong": lambda c: c.level >= 0.5,
    "correlated": lambda c: c.correlation > 0,
    "real": lambda c: c.shape.startswith(("LaserScan", "DepthCamera")),
    "voxels": lambda c: c.slices == 1,
    "slices 3": lambda c: c.slices == 3,
    "slices 6": lambda c: c.slices == 6,
}

FINAL_GROUPS = {
    "along normals": lambda c: is_base(c) and c.direction == "normal",
    "any direction": GROUPS["any direction"],
    "correlated over 1.5": GROUPS["correlated"],
    **{f"voxels, slices {d}": lambda c, d=d: c.slices == d for d in (1, 2, 4)},
}
