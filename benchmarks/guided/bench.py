# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of the cases, and the figures of every method on them."""

import json
import subprocess
import sys

from .methods import Methods
from .runs import DATA, WORK, run

VERTICES = 3000
VOXEL_VERTICES = 10000
LARGE = 35000


class Bench:
    def __init__(self, folder, peers):
        self.tool = folder / "anisosmooth"
        self.variant_tool = folder / "guided_variant"
        self.shapes_tool = folder / "write_clean_shapes"
        self.methods = Methods(self.tool, peers)
        self.variants = {}

    def clean(self, case, vertices=VERTICES):
        """The truth."""
        if case.slices:
            return self.voxels(case)[1]
        if case.direction == "given":
            return self.given(case, "original")
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
        surface = WORK / f"{case.shape}_{case.slices}.obj"
        truth = WORK / f"{case.shape}_{case.slices}_truth.obj"
        if not surface.exists() or not truth.exists():
            run(self.tool, "generate", case.shape, surface, "--vertices", VOXEL_VERTICES, "--slice-distance", case.slices,
                "--truth", truth, "--quiet")
        return surface, truth

    def noisy(self, case, vertices=VERTICES):
        if case.slices:
            return self.voxels(case)[0]
        if case.direction == "given":
            return self.given(case, "noisy")
        path = WORK / (f"{case.shape}_{vertices}_{case.level}_{case.direction}" +
                       (f"_{case.correlation}" if case.correlation else "") + ".obj")
        if not path.exists():
            run(self.tool, "noise", self.clean(case, vertices), path, "--level", case.level, "--seed", 7, "--direction",
                case.direction, "--correlation", case.correlation, "--quiet")
        return path

    def measure(self, result, case, vertices=VERTICES):
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
        kept = WORK / f"{'_'.join(map(str, case))}_{name}.json"
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
