# SPDX-License-Identifier: GPL-3.0-or-later
import os
import warnings

import numpy as np

from . import _arrays, _core


class MeshFile:
    """A mesh as it was read. Its arrays are made when they are first asked for."""

    def __init__(self, core):
        self._core = core
        self._kept = {}

    def _array(self, name):
        if name not in self._kept:
            self._kept[name] = getattr(self._core, name)
        return self._kept[name]

    @property
    def V(self):
        """(n, 3) positions: float32 if the file has single precision, else float64."""
        return self._array("positions")

    @property
    def F(self):
        """(m, 3) int64 triangles; polygons of the file are cut."""
        return self._array("triangles")

    @property
    def creases(self):
        """(k, 2) int64: edges that the file names, as pairs of vertices, for smooth's `creases`; None if there are none."""
        return self._array("edges")

    @property
    def colors(self):
        """(n, 4) bytes of red, green, blue and alpha, or None."""
        return self._array("colors")

    @property
    def scalars(self):
        """(n,) float64, the vertices' quality, or None."""
        return self._array("scalars")

    @property
    def selected(self):
        """(n,) bool: vertices that are selected or belong to a selected face; None if nothing is selected."""
        return self._array("selected")

    @property
    def warnings(self):
        """What is odd about the file, in sentences."""
        return list(self._core.warnings)

    def __repr__(self):
        return f"<anisosmooth.MeshFile {os.fspath(self._core.path)!r}: {len(self.V)} vertices, {len(self.F)} triangles>"


def read(path):
    """Reads PLY, OBJ, OFF, STL, GLB or glTF, told by the extension. STL knows no shared vertices: those at exactly the same place
    become one.

    Raises OSError with a sentence that says what is wrong with the file, and where.
    """
    return MeshFile(_core.read(os.fspath(path)))


def write(path, V, F=None, *, colors=None, scalars=None, like=None):
    """Writes a mesh, complete or not at all, in the format that the extension names.

    like : what read() returned
        In the format that was read, the file is the same byte for byte but for the coordinates that moved, and normals:
        groups, materials, polygons, comments and unknown properties stay. F is then not needed.

    What the format cannot hold is named by a Python warning. Raises OSError, ValueError.
    """
    vertices = _arrays.positions(V)
    if colors is not None:
        colors = _arrays.colors(colors, len(vertices))[0]
    if scalars is not None:
        scalars = _arrays.per_vertex(scalars, "scalars", len(vertices))
    if like is not None:
        if F is not None and not np.array_equal(np.asarray(F), like.F):
            raise ValueError("F differs from the faces of the file that is given as `like`")
        if vertices.shape != like.V.shape:
            raise ValueError(f"V has {len(vertices)} vertices, the file that is given as `like` {len(like.V)}")
        sentences = _core.write_moved(os.fspath(path), like._core, vertices, colors, scalars)
    elif F is None:
        raise ValueError("F is missing; without `like` there are no faces to write")
    else:
        faces = np.ascontiguousarray(_arrays.triangles(F), np.int64)
        sentences = _core.write(os.fspath(path), vertices, faces, colors, scalars)
    for sentence in sentences:
        warnings.warn(sentence, stacklevel=2)
