# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of the cases, and the figures of every method on them."""

import json
import subprocess
import sys
from collections import namedtuple

from .methods import Methods
from .runs import DATA, WORK, run

LARGE = 35000


class Drawing(namedtuple("Drawing", "seed vertices voxel_vertices")):
    """What the files of the cases are made with."""

    def tag(self):
        return "" if self == TUNING else f"_{self.seed}"


# The first is what constants were chosen by; the second was looked at once, when all was chosen.
TUNING = Drawing(seed=7, vertices=3000, voxel_vertices=10000)
FINAL = Drawing(seed=23, vertices=5000, voxel_vertices=14000)


class Bench:
    def __init__(self, folder, peers, drawing=TUNING):
        self.drawing = drawing
        self.tool = folder / "anisosmooth"
        self.variant_tool = folder / "guided_variant"
        self.shapes_tool = folder / "write_clean_shapes"
        self.methods = Methods(self.tool, peers)
        self.variants = {}

    def clean(self, case, vertices=None):
        """The truth."""
        if case.slices:
            return self.voxels(case)[1]
        if case.direction == "given":
            return self.given(case, "original")
        vertices = vertices or self.drawing.vertices
        path = WORK / f"{case.shape}_{vertices}.obj"
        if not path.exists():
            run(self.tool, "generate", case.shape, path, "--vertices", vertices, "--quiet")
        return path

    def given(self, case, name):
        """One of a pair of files, as OBJ, which every peer reads."""
        path = DATA / case.shape / f"{name}.obj"
        if path.exists():
            return path
        copy = WORK / f"{case.shape}_{name}.obj"
        if not copy.exists():
            run(self.tool, "noise", path.with_suffix(".ply"), copy, "--level", 0, "--quiet")
        return copy

    def voxels(self, case):
        """The surface of the voxels, and the shape itself."""
        surface = WORK / f"{case.shape}_{case.slices}{self.drawing.tag()}.obj"
        truth = WORK / f"{case.shape}_{case.slices}{self.drawing.tag()}_truth.obj"
        if not surface.exists() or not truth.exists():
            run(self.tool, "generate", case.shape, surface, "--vertices", self.drawing.voxel_vertices, "--slice-distance", case.slices,
                "--truth", truth, "--quiet")
        return surface, truth

    def noisy(self, case, vertices=None):
        if case.slices:
            return self.voxels(case)[0]
        if case.direction == "given":
            return self.given(case, "noisy")
        vertices = vertices or self.drawing.vertices
        path = WORK / (f"{case.shape}_{vertices}_{case.level}_{case.direction}" +
                       (f"_{case.correlation}" if case.correlation else "") + self.drawing.tag() + ".obj")
        if not path.exists():
            run(self.tool, "noise", self.clean(case, vertices), path, "--level", case.level, "--seed",
                self.drawing.seed, "--direction",
                case.direction, "--correlation", case.correlation, "--quiet")
        return path

    def measure(self, result, case, vertices=None):
        done = subprocess.run([self.tool, "measure", result, self.clean(case, vertices), "--json"],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"guided_benchmark: {result}: {done.stderr.strip()}")
        return json.loads(done.stdout)

    def report(self, source, target):
        """What the guided method says of its run."""
        report = WORK / "report.json"
        run(self.tool, "smooth", source, target, "--method", "guided", "--quiet", "--report", report)
        return json.loads(report.read_text())

    def seconds(self, name, source, target):
        return sum(self.methods.results(name, source, target))

    def figures(self, name, case):
        """Figures of one method on one case. Those of peers are kept: they do not change with this project."""
        kept = WORK / f"{'_'.join(map(str, case))}{self.drawing.tag()}_{name}.json"
        foreign = name not in ("paper", "guided")
        if foreign and kept.exists():
            return json.loads(kept.read_text())
        target = WORK / "result.obj"
        if name == "noisy":
            figures = self.measure(self.noisy(case), case)
        else:
            found = [{"seconds": seconds, **self.measure(target, case)}
                     for seconds in self.methods.results(name, self.noisy(case), target)]
            figures = min(found, key=lambda f: f["normal_error_mean"])
        kept.write_text(json.dumps(figures))
        return figures

    def variant(self, settings, case):
        key = (case, *settings)
        if key not in self.variants:
            target = WORK / "variant.obj"
            run(self.variant_tool, self.noisy(case), target, *settings)
            self.variants[key] = self.measure(target, case)
        return self.variants[key]
