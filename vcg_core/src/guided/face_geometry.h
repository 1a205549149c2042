#pragma once

#include <vcg_core/detail/mesh_arrays.h>

namespace vcg_core::detail {

/// Normals, centroids and areas of all faces, for vertices at `position`. The normal of a face without area is zero.
struct FaceGeometry {
  std::vector<Vec3> normal;
  std::vector<Vec3> centroid;
  std::vector<double> area;

  void measure(const MeshArrays& mesh, const std::vector<Vec3>& position, Job& job);
};

}  // namespace vcg_core::detail
