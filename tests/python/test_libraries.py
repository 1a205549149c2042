# SPDX-License-Identifier: GPL-3.0-or-later
"""The doors for meshes of other libraries, against the real ones."""

import numpy as np
import pytest

import anisosmooth


def test_trimesh(mesh):
    trimesh = pytest.importorskip("trimesh", exc_type=ImportError)
    from anisosmooth.trimesh import filter_guided

    V, F, _ = mesh
    shape = trimesh.Trimesh(V, F, process=False)
    area = shape.area
    assert filter_guided(shape, strength=1.0) is shape
    np.testing.assert_array_equal(shape.vertices, anisosmooth.smooth(V, F, strength=1.0))
    assert shape.area < area


def test_pyvista(mesh):
    pyvista = pytest.importorskip("pyvista", exc_type=ImportError)
    V, F, _ = mesh
    shape = pyvista.PolyData.from_regular_faces(V.astype(np.float32), F)
    shape.point_data["label"] = np.arange(len(V))
    shape.compute_normals(cell_normals=False, split_vertices=False, inplace=True)
    before = shape.points.copy()
    result = shape.anisosmooth.denoise()
    np.testing.assert_array_equal(shape.points, before)
    np.testing.assert_array_equal(result.points, anisosmooth.smooth(before, shape.regular_faces))
    np.testing.assert_array_equal(result.point_data["label"], np.arange(len(V)))
    assert not np.array_equal(result.point_data["Normals"], shape.point_data["Normals"])
    plane = pyvista.Plane(i_resolution=20, j_resolution=20)
    plane.points[:, 2] += np.random.default_rng(6).normal(scale=0.01, size=plane.n_points)
    smooth = plane.anisosmooth.denoise(boundary="fixed")
    assert smooth.n_cells == 400 and smooth.points[:, 2].std() < plane.points[:, 2].std() / 2


def test_open3d(mesh):
    open3d = pytest.importorskip("open3d", exc_type=ImportError)
    from anisosmooth.open3d import filter_smooth_guided

    V, F, _ = mesh
    shape = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(V), open3d.utility.Vector3iVector(F))
    shape.vertex_colors = open3d.utility.Vector3dVector(np.full((len(V), 3), 0.25))
    shape.triangle_uvs = open3d.utility.Vector2dVector(np.random.default_rng(7).random((3 * len(F), 2)))
    shape.compute_vertex_normals()
    result = filter_smooth_guided(shape)
    np.testing.assert_array_equal(np.asarray(shape.vertices), V)
    np.testing.assert_array_equal(np.asarray(result.vertices), anisosmooth.smooth(V, F))
    np.testing.assert_array_equal(np.asarray(result.vertex_colors), np.asarray(shape.vertex_colors))
    np.testing.assert_array_equal(np.asarray(result.triangle_uvs), np.asarray(shape.triangle_uvs))
    assert not np.allclose(np.asarray(result.vertex_normals), np.asarray(shape.vertex_normals))
