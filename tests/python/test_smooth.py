# SPDX-License-Identifier: GPL-3.0-or-later
"""smooth() against the command line, the truth, and what its keywords promise."""

import json
import subprocess
import warnings

import numpy as np
import pytest

import anisosmooth
from anisosmooth._smooth import CATALOGUE, parameters_of
from conftest import ROOT, torus


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("method", list(CATALOGUE))
def test_gives_the_bits_of_the_command_line(method, dtype, mesh, command_line, tmp_path):
    V, F = mesh[0].astype(dtype), mesh[1]
    anisosmooth.write(tmp_path / "in.ply", V, F)
    report_path = tmp_path / "report.json"
    subprocess.run(
        [command_line, "smooth", "in.ply", "out.ply", "--method", method, "--report", report_path, "--quiet"],
        cwd=tmp_path, check=True,
    )  # fmt: skip
    result, report = anisosmooth.smooth(V, F, method, return_report=True)
    assert result.dtype == dtype
    np.testing.assert_array_equal(result, anisosmooth.read(tmp_path / "out.ply").V)
    written = json.loads(report_path.read_text())
    assert {name: written[name] for name in report} == report


def test_takes_the_noise_away(mesh):
    V, F, truth = mesh
    before = anisosmooth.measure(V, F, truth)["normal_error_mean"]
    after = anisosmooth.measure(anisosmooth.smooth(V, F), F, truth)["normal_error_mean"]
    assert after < before / 3


def test_leaves_the_callers_arrays(mesh):
    V, F = mesh[0].copy(), mesh[1].copy()
    colors = np.full((len(V), 3), 0.5)
    anisosmooth.smooth(V, F, colors=colors, scalars=V[:, 0])
    np.testing.assert_array_equal(V, mesh[0])
    np.testing.assert_array_equal(F, mesh[1])
    assert (colors == 0.5).all()


def test_keywords_reach_the_filter(mesh):
    V, F = mesh[:2]
    default = anisosmooth.smooth(V, F, "paper")
    assert not np.array_equal(default, anisosmooth.smooth(V, F, "paper", sigma_c=3.0))
    assert not np.array_equal(default, anisosmooth.smooth(V, F, "paper", gaussian="printed"))
    np.testing.assert_array_equal(default, anisosmooth.smooth(V, F, "paper", sigma_c=np.float32(2), iterations=np.int8(1)))
    np.testing.assert_array_equal(default, anisosmooth.smooth(V, F, "paper", sigma_c=None))


def test_holds_the_border():
    points, faces = torus()
    open_faces = faces[(faces < len(points) // 2).all(axis=1)]
    used = np.unique(open_faces)
    edges = np.sort(open_faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, counts = np.unique(edges, axis=0, return_counts=True)
    border = np.unique(unique[counts == 1])
    shaken = points + np.random.default_rng(2).normal(scale=0.01, size=points.shape)
    held = anisosmooth.smooth(shaken, open_faces, "paper", boundary="fixed")
    free = anisosmooth.smooth(shaken, open_faces, "paper", boundary="free")
    np.testing.assert_array_equal(held[border], shaken[border])
    assert (free[border] != shaken[border]).any(axis=1).all()
    inner = np.setdiff1d(used, border)
    assert (held[inner] != shaken[inner]).any(axis=1).mean() > 0.99


def test_selected_weights_and_limits(mesh):
    V, F = mesh[:2]
    mask = np.arange(len(V)) < 300
    result = anisosmooth.smooth(V, F, selected=mask)
    np.testing.assert_array_equal(result[~mask], V[~mask])
    np.testing.assert_array_equal(result, anisosmooth.smooth(V, F, selected=np.flatnonzero(mask)))
    weights = mask.astype(np.float32)
    np.testing.assert_array_equal(anisosmooth.smooth(V, F, weights=weights)[~mask], V[~mask])
    np.testing.assert_array_equal(anisosmooth.smooth(V, F, max_displacement=0), V)
    limited = anisosmooth.smooth(V, F, max_displacement=0.002)
    assert np.linalg.norm(limited - V, axis=1).max() <= 0.002 * (1 + 1e-9)


def test_creases_stay_sharp():
    # A roof of 12 degrees, under the feature angle of 30, with noise.
    n = 30
    x, y = np.meshgrid(np.arange(-n, n + 1.0), np.arange(2 * n + 1.0), indexing="ij")
    height = -np.tan(np.radians(6)) * np.abs(x)
    noise = np.random.default_rng(8).normal(scale=0.15, size=x.shape)
    V = np.stack([x, y, height + noise], axis=-1).reshape(-1, 3)
    side = 2 * n + 1
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    F = np.concatenate([np.stack([corner, corner + side, corner + side + 1], 1), np.stack([corner, corner + side + 1, corner + 1], 1)])  # fmt: skip
    ridge = n * side + np.arange(side)
    creases = np.stack([ridge[:-1], ridge[1:]], axis=1)
    plain = anisosmooth.smooth(V, F)
    creased, report = anisosmooth.smooth(V, F, creases=creases, return_report=True)
    assert report["crease_edges"] == len(creases)
    inner = ridge[5:-5]
    assert np.abs(creased[inner, 2]).mean() < 0.7 * np.abs(plain[inner, 2]).mean()
    with pytest.raises(ValueError):
        anisosmooth.smooth(V, F, creases=[[0, len(V)]])


def test_vertices_at_one_place_are_one(mesh):
    V, F = mesh[:2]
    whole = anisosmooth.smooth(V, F)
    soup = anisosmooth.smooth(V[F].reshape(-1, 3), np.arange(3 * len(F)).reshape(-1, 3))
    np.testing.assert_array_equal(soup.reshape(-1, 3, 3), whole[F])


def test_colors_come_back_in_their_form(mesh):
    V, F = mesh[:2]
    fractions = np.random.default_rng(3).random((len(V), 4)).astype(np.float32)
    result, colors, scalars = anisosmooth.smooth(V, F, colors=fractions, scalars=V[:, 0])
    assert colors.shape == fractions.shape and colors.dtype == fractions.dtype
    assert 0 < np.abs(colors - fractions)[:, :3].max() <= 1
    assert (scalars != V[:, 0]).any()
    as_bytes = np.rint(fractions[:, :3] * 255).astype(np.uint8)
    np.testing.assert_array_equal(
        anisosmooth.smooth(V, F, colors=as_bytes)[1], np.rint(colors[:, :3] * 255).astype(np.uint8)
    )
    np.testing.assert_array_equal(result, anisosmooth.smooth(V, F))


def test_warns_where_no_report_is_asked_for():
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]  # fmt: skip
    with pytest.warns(UserWarning, match="volume"):
        anisosmooth.smooth(cube, faces, "paper")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        report = anisosmooth.smooth(cube, faces, "paper", return_report=True)[1]
        np.testing.assert_array_equal(anisosmooth.smooth(cube, faces, return_report=True)[0], cube)
    assert any("volume" in sentence for sentence in report["warnings"])


def test_parameters_are_those_of_meshlab():
    """Names and defaults of the plugin's released filters: the snapshot that its own tests hold it to."""
    filters = json.loads((ROOT / "tests/plugin/filters.json").read_text())
    by_title = {"Anisotropic Feature-Preserving Smoothing": "paper", "Bilateral Mesh Denoising": "bmd",
                "Non-Iterative Feature-Preserving Smoothing": "jones", "Guided Anisotropic Smoothing": "guided"}  # fmt: skip
    compared = 0
    for entry in filters:
        method = by_title.get(entry["name"])
        if method is None:
            continue
        rows = {row["name"]: row for row in CATALOGUE[method]["parameters"]}
        for parameter in entry["parameters"]:
            row = rows[parameter["name"]]
            if row["by_selection"]:
                continue
            value = row["choices"].index(row["default"]) if row["choices"] else row["default"]
            assert value == pytest.approx(parameter["default"], rel=1e-6), parameter["name"]
            compared += 1
    assert compared >= 15


def test_parameters_are_those_of_the_command_line(command_line):
    text = subprocess.run([command_line, "smooth", "--help"], check=True, capture_output=True, text=True).stdout
    for method in CATALOGUE:
        for row in parameters_of(method):
            assert "--" + row["name"].replace("_", "-") in text
