# SPDX-License-Identifier: GPL-3.0-or-later
"""For PyVista: mesh.anisosmooth.denoise(). PyVista finds it by itself, by the entry point "pyvista.accessors"."""

import pyvista

from . import smooth


@pyvista.register_dataset_accessor("anisosmooth", pyvista.PolyData)
class Accessor:
    def __init__(self, mesh):
        self._mesh = mesh

    def denoise(self, **keywords):
        """A new mesh, smoothed; all data of points and cells stay, normals are made anew where the points have them.
        Polygons stay polygons. Keywords are those of anisosmooth.smooth().
        """
        mesh = self._mesh
        triangles = mesh if mesh.is_all_triangles else mesh.triangulate()
        result = mesh.copy()
        result.points = smooth(mesh.points, triangles.regular_faces, **keywords)
        if "Normals" in result.point_data:
            del result.point_data["Normals"]  # VTK makes no new ones where there are some
            result.compute_normals(
                cell_normals=False, split_vertices=False, consistent_normals=False, auto_orient_normals=False,
                inplace=True,
            )  # fmt: skip
        return result
