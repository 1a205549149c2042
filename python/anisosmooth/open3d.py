# SPDX-License-Identifier: GPL-3.0-or-later
"""For Open3D, in the manner of TriangleMesh.filter_smooth_taubin."""

import numpy as np
import open3d

from . import smooth


def filter_smooth_guided(mesh, **keywords):
    """A new open3d.geometry.TriangleMesh, smoothed. Colours, texture coordinates and materials are kept; normals are
    made anew where the mesh has them. Keywords are those of anisosmooth.smooth().
    """
    result = open3d.geometry.TriangleMesh(mesh)
    smoothed = smooth(np.asarray(mesh.vertices), np.asarray(mesh.triangles), **keywords)
    result.vertices = open3d.utility.Vector3dVector(smoothed)
    if mesh.has_triangle_normals():
        result.compute_triangle_normals()
    if mesh.has_vertex_normals():
        result.compute_vertex_normals()
    return result
