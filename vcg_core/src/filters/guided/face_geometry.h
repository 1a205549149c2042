// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "mesh_arrays.h"
#include "unit_normals.h"

namespace vcg_core::detail {

/// Twice the area of a face along its normal.
/// @param position  gives the place of a vertex by []
template <class Positions>
Vec3 area_vector(const MeshArrays& mesh, const Positions& position, std::size_t f) {
  const auto& v = mesh.face[f];
  return (position[v[1]] - position[v[0]]).cross(position[v[2]] - position[v[0]]);
}

/// The unit normal of a face with this area vector, or zero where it has no area.
inline Vec3 direction_of_face(const Vec3& area_vector) {
  const double length = area_vector.norm();
  return length > 0 ? Vec3(area_vector / length) : Vec3(Vec3::Zero());
}

inline Vec3 centroid_of(const MeshArrays& mesh, const Array<Vec3>& position, std::size_t f) {
  const auto& v = mesh.face[f];
  return (position[v[0]] + position[v[1]] + position[v[2]]) / 3;
}

/// Normals and areas of all faces, for vertices at `position`. The normal of a face without area is zero.
struct FaceGeometry {
  Array<UnitNormal> normal;
  Array<double> area;

  void measure(const MeshArrays& mesh, const Array<Vec3>& position, Job& job);
};

}  // namespace vcg_core::detail
