# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes for the tests, made here: the package is tested as a user has it, without the project around it."""

import os
import pathlib
import shutil

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def torus(around=60, across=24, radius=0.35):
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u / around, 2 * np.pi * v / across
    ring = 1 + radius * np.cos(b)
    points = np.stack([ring * np.cos(a), ring * np.sin(a), radius * np.sin(b)], axis=-1).reshape(-1, 3)

    def index(i, j):
        return (i % around) * across + j % across

    corners = [index(u, v), index(u + 1, v), index(u + 1, v + 1), index(u, v + 1)]
    p, q, r, s = (corner.ravel() for corner in corners)
    return points, np.concatenate([np.stack([p, q, r], 1), np.stack([p, r, s], 1)])


def noisy(points, sigma=0.025, seed=1):
    return points + np.random.default_rng(seed).normal(scale=sigma, size=points.shape)


@pytest.fixture(scope="session")
def mesh():
    """(V, F, V_true): a torus with noise of a quarter of its edges."""
    points, faces = torus()
    return noisy(points), faces, points


@pytest.fixture(scope="session")
def command_line():
    """The project's own command line, to compare with."""
    program = os.environ.get("ANISOSMOOTH") or shutil.which("anisosmooth")
    if not program:
        pytest.skip("no command line to compare with: set ANISOSMOOTH")
    return program
