// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Normals, centroids and areas of all faces, for vertices at `position`. The normal of a face without area is zero.
struct FaceGeometry {
  Array<Vec3> normal;
  Array<Vec3> centroid;
  Array<double> area;

  void measure(const MeshArrays& mesh, const Array<Vec3>& position, Job& job);
};

}  // namespace vcg_core::detail
