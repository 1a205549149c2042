# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of the public functions as the arrays that the compiled part takes."""

import numpy as np


def _rows(array, name, columns):
    if columns is None:
        if array.ndim != 1:
            raise ValueError(f"{name} must have one number for each vertex, not the shape {array.shape}")
    elif array.ndim != 2 or array.shape[1] not in columns:
        widths = " or ".join(str(width) for width in columns)
        raise ValueError(f"{name} must have the shape (n, {widths}), not {array.shape}")
    # The numbers of a row lie side by side, and rows at whole numbers of items; anything else is copied.
    fits = all(stride % array.itemsize == 0 for stride in array.strides) and (
        columns is None or array.strides[1] == array.itemsize
    )
    return array if fits else np.ascontiguousarray(array)


def _real(values, name):
    array = np.asarray(values)
    if array.dtype.kind not in "fiub":
        raise ValueError(f"{name} must hold real numbers, not {array.dtype}")
    if array.dtype in (np.float32, np.float64):
        return array.astype(array.dtype.newbyteorder("="), copy=False)
    return array.astype(np.float64)


def positions(values, name="V"):
    """(n, 3) of float32 or float64; other numbers become float64. A view of the caller's memory where it can be."""
    return _rows(_real(values, name), name, (3,))


def per_vertex(values, name, count):
    """(n,) of float32 or float64."""
    array = _rows(_real(values, name), name, None)
    if len(array) != count:
        raise ValueError(f"{name} has {len(array)} numbers for {count} vertices")
    return array


def _indices(values, name, width):
    array = np.asarray(values)
    if array.size == 0:
        return np.zeros((0, width), np.int64)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{name} must hold integers, the indices of vertices, not {array.dtype}")
    if array.dtype.itemsize < 4:
        array = array.astype(np.int32)
    return _rows(array.astype(array.dtype.newbyteorder("="), copy=False), name, (width,))


def triangles(values, name="F"):
    """(m, 3) of integers of 32 or 64 bits. A view of the caller's memory where it can be."""
    return _indices(values, name, 3)


def edges(values, name="creases"):
    """(k, 2) of integers of 32 or 64 bits."""
    return _indices(values, name, 2)


def without_place(vertices, faces, creases=None):
    """(n,) of bytes, 1 where a vertex has no finite place and nothing uses it; None if there is no such vertex."""
    undefined = ~np.isfinite(vertices).all(axis=1)
    if not undefined.any():
        return None
    for users in (faces, creases):
        if users is not None:
            undefined[users[(users >= 0) & (users < len(vertices))]] = False
    return undefined.astype(np.uint8) if undefined.any() else None


def marks(values, name, count):
    """(n,) of bytes, 0 or 1, from booleans or from indices of vertices."""
    array = np.asarray(values)
    if array.dtype == bool:
        if array.shape != (count,):
            raise ValueError(f"{name} has the shape {array.shape} for {count} vertices")
        return array.astype(np.uint8)
    if array.size > 0 and (array.dtype.kind not in "iu" or array.ndim != 1):
        raise ValueError(f"{name} must hold a bool for each vertex, or indices of vertices")
    if array.size > 0 and (array.min() < 0 or array.max() >= count):
        raise ValueError(f"{name} names a vertex that the mesh does not have")
    result = np.zeros(count, np.uint8)
    result[array.astype(np.int64)] = 1
    return result


def colors(values, count):
    """A copy as (n, 4) bytes, with a function that brings the result back to the caller's form: (n, 3) or (n, 4) of
    bytes, or of fractions from 0 to 1."""
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] not in (3, 4) or len(array) != count:
        raise ValueError(f"colors must have the shape ({count}, 3) or ({count}, 4), not {array.shape}")
    width, dtype = array.shape[1], array.dtype
    fractions = dtype.kind == "f"
    if fractions:
        if not ((array >= 0) & (array <= 1)).all():
            raise ValueError("colors that are not whole numbers must lie between 0 and 1")
        array = np.rint(array * 255)
    elif dtype.kind not in "iu" or (array.size > 0 and (array.min() < 0 or array.max() > 255)):
        raise ValueError("colors must be whole numbers from 0 to 255, or fractions from 0 to 1")
    quads = np.full((count, 4), 255, np.uint8)
    quads[:, :width] = array

    def back(smoothed):
        kept = smoothed[:, :width]
        return (kept / 255).astype(dtype) if fractions else kept.astype(dtype)

    return quads, back
