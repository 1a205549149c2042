# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example of docs/python.md runs, in a folder with scan.ply and scans/."""

import re
import subprocess
import sys

import pytest

import anisosmooth
from conftest import ROOT, noisy, torus

EXAMPLES = re.findall(r"^## (.*?)$|^```python\n(.*?)^```$", (ROOT / "docs/python.md").read_text(), re.M | re.S)


def examples():
    title, counts = "arrays", {}
    for heading, code in EXAMPLES:
        if heading:
            title = heading
            continue
        counts[title] = counts.get(title, 0) + 1
        yield pytest.param(code, id=f"{title} {counts[title]}".replace(" ", "_"))


@pytest.mark.parametrize("code", examples())
def test_example_runs(code, tmp_path):
    for module in re.findall(r"^(?:import|from) (trimesh|pyvista|open3d|skimage)", code, re.M):
        pytest.importorskip(module, exc_type=ImportError)
    points, faces = torus(100, 40)
    (tmp_path / "scans").mkdir()
    for name in ("scan.ply", "scans/a.ply", "scans/b.ply"):
        anisosmooth.write(tmp_path / name, noisy(points, 0.008), faces)
    # scikit-image 0.26 does what numpy 2.5 warns of.
    theirs = "ignore::DeprecationWarning:skimage.measure._marching_cubes_lewiner"
    subprocess.run([sys.executable, "-W", "error", "-W", theirs, "-c", code], cwd=tmp_path, check=True)
    made = {path.name for path in tmp_path.rglob("*")} - {"scans", "scan.ply", "a.ply", "b.ply"}
    for name in re.findall(r'"((?:smooth|clean)[^"]*)"', code):
        assert name in made
    if "clean" in made:
        assert {path.name for path in (tmp_path / "clean").iterdir()} == {"a.ply", "b.ply"}


def test_there_are_examples():
    assert len(list(examples())) >= 7
