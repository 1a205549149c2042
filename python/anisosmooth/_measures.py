# SPDX-License-Identifier: GPL-3.0-or-later
import json

import numpy as np

from . import _arrays, _core


def distance(V, F, source, progress=None):
    """Geodesic distance from one vertex to all others, by fast marching with a virtual start point.

    V : (n, 3) float32 or float64;  F : (m, 3) integers;  source : index of a vertex

    Returns (n,) float64, in the unit of V; infinity where no path of faces leads.
    Raises ValueError, Cancelled (see smooth).
    """
    index = int(np.asarray(source).__index__())
    if index < 0:
        raise ValueError(f"source is {index}; allowed are indices of vertices, from 0 on")
    vertices, faces = _arrays.positions(V), _arrays.triangles(F)
    return _core.distance(vertices, faces, _arrays.without_place(vertices, faces), index, progress)


def estimate_noise(V, F, threads=0, progress=None):
    """Standard deviation of the noise along the normals, in the unit of V, as the guided filter sees it; 0 if there is
    none that can be told from the shape.

    V : (n, 3) float32 or float64;  F : (m, 3) integers
    Raises ValueError, Cancelled (see smooth).
    """
    vertices, faces = _arrays.positions(V), _arrays.triangles(F)
    return _core.estimate_noise(vertices, faces, _arrays.without_place(vertices, faces), threads, progress)


def measure(V, F, V_ref, F_ref=None, V_noisy=None, threads=0):
    """Compares a mesh with the truth, face by face.

    V, V_ref : (n, 3);  F : (m, 3);  F_ref : the truth's faces, if they are others than F;  V_noisy : before smoothing

    Returns a dictionary: angles between normals in degrees, distances in average edge lengths of the truth, the change
    of volume in percent, faces turned over. docs/command-line.md explains each, under `anisosmooth measure`.
    Raises ValueError.
    """
    faces = _contiguous(F)
    return json.loads(
        _core.measure(
            _arrays.positions(V), faces, _arrays.positions(V_ref, "V_ref"),
            faces if F_ref is None else _contiguous(F_ref, "F_ref"),
            None if V_noisy is None else _arrays.positions(V_noisy, "V_noisy"), threads,
        )
    )  # fmt: skip


def _contiguous(F, name="F"):
    return np.ascontiguousarray(_arrays.triangles(F, name), np.int64)
