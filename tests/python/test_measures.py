# SPDX-License-Identifier: GPL-3.0-or-later
import json
import subprocess

import numpy as np
import pytest

import anisosmooth


def test_distance_on_a_plane_is_straight():
    n = 21
    x, y = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    V = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3).astype(float)
    corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    F = np.concatenate([np.stack([corner, corner + n, corner + n + 1], 1), np.stack([corner, corner + n + 1, corner + 1], 1)])
    np.testing.assert_allclose(anisosmooth.distance(V, F, 0), np.linalg.norm(V, axis=1), atol=1e-12)
    with pytest.raises(ValueError, match="start vertex|source"):
        anisosmooth.distance(V, F, len(V))
    with pytest.raises(ValueError):
        anisosmooth.distance(V, F, -1)
    with pytest.raises((TypeError, AttributeError)):
        anisosmooth.distance(V, F, 0.5)
    separate = np.concatenate([V, V + [100, 0, 0]])
    both = anisosmooth.distance(separate, np.concatenate([F, F + len(V)]), 0)
    assert np.isinf(both[len(V) :]).all()


def test_noise_is_estimated():
    from conftest import torus

    V, F = torus(200, 80)
    edges = np.sort(F[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    e = np.linalg.norm(V[edges[:, 0]] - V[edges[:, 1]], axis=1).mean()
    assert anisosmooth.estimate_noise(V, F) < 0.02 * e
    shaken = V + np.random.default_rng(4).normal(scale=0.2 * e, size=V.shape)
    assert anisosmooth.estimate_noise(shaken, F) == pytest.approx(0.2 * e, rel=0.2)


def test_measure_is_the_command_lines(mesh, command_line, tmp_path):
    V, F, truth = mesh
    smooth = anisosmooth.smooth(V, F)
    for name, points in {"smooth": smooth, "noisy": V, "truth": truth}.items():
        anisosmooth.write(tmp_path / f"{name}.ply", points, F)
    text = subprocess.run(
        [command_line, "measure", "smooth.ply", "truth.ply", "--noisy", "noisy.ply", "--json"],
        cwd=tmp_path, check=True, capture_output=True, text=True,
    ).stdout  # fmt: skip
    assert anisosmooth.measure(smooth, F, truth, V_noisy=V) == json.loads(text)
    assert anisosmooth.measure(truth, F, truth)["normal_error_mean"] == pytest.approx(0, abs=1e-6)
    with pytest.raises(ValueError):
        anisosmooth.measure(V[:-1], F[:5], truth)
