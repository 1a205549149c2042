# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooths a mesh in PyMeshLab by this project's plugin.

python3 pymeshlab_example.py PLUGIN.so IN OUT
"""

import sys

import pymeshlab

plugin, source, target = sys.argv[1:]
pymeshlab.load_plugin(plugin)

meshes = pymeshlab.MeshSet()
meshes.load_new_mesh(source)
report = meshes.apply_filter("apply_coord_anisotropic_smoothing", sigma_c=2.0, sigma_s=1.0, sigma_n=0.3, rho=2.0,
                             iterations=1, boundary="fixed", selected=False)
print(f"moved {report['moved_vertices']} of {report['vertices']} vertices, at most by {report['max_displacement']:.4g};"
      f" volume {report['volume_before']:.6g} before, {report['volume_after']:.6g} after")
meshes.save_current_mesh(target)
