// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

namespace training {

/// The surface of a random solid as marching cubes makes it of its distance on a grid: triangles of all sizes.
mesh_tools::Mesh isosurface(mesh_tools::Random& random);

/// A surface out of a volume whose noise is in the volume.
struct VolumeSurface {
  mesh_tools::Mesh mesh;
  std::vector<vcg::Point3d> normal;  ///< of the solid where each face should lie
};

/// The surface of a solid as marching cubes makes it of the labels inside and outside on a grid, as of a segmented CT,
/// in slices that may lie farther apart than its pixels.
VolumeSurface label_surface(mesh_tools::Random& random);

/// The surface as marching cubes makes it of noisy distances on a grid, as they are fused of a depth camera's images.
VolumeSurface fused_surface(mesh_tools::Random& random);

}  // namespace training
