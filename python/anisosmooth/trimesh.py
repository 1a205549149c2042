# SPDX-License-Identifier: GPL-3.0-or-later
"""For trimesh, in the manner of trimesh.smoothing."""

from . import smooth


def filter_guided(mesh, **keywords):
    """Smooths a trimesh.Trimesh in place and returns it. Vertices at the same place move as one, so that meshes with
    texture coordinates do not tear. Keywords are those of anisosmooth.smooth().
    """
    mesh.vertices = smooth(mesh.vertices, mesh.faces, **keywords)
    return mesh
