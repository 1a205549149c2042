// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_normals.h"

#include <Eigen/Geometry>

#include "angle.h"
#include "face_area.h"
#include "job.h"

namespace vcg_core::detail {

namespace {

/// Below this length a sum of unit normals is what rounding left of normals that cancel each other.
constexpr double cancelled = 1e-9;

Vec3 vertex_normal(const MeshArrays& mesh, const Array<Vec3>& position, Index v) {
  Vec3 sum = Vec3::Zero();
  const MeshTopology& topology = mesh.topology;
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Index corner = topology.star[s];
    const Vec3 a = position[vertex_of(mesh, next_in_face(corner))] - position[v];
    const Vec3 b = position[vertex_of(mesh, previous_in_face(corner))] - position[v];
    const Vec3 cross = a.cross(b);
    if (!has_area(a, b, cross)) continue;
    const double twice_area = cross.norm();
    sum += cross * (angle_between(twice_area, a.dot(b)) / twice_area);
  }
  const double length = sum.norm();
  return length > cancelled ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

}  // namespace

Array<Vec3> vertex_normals(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  Array<Vec3> normal(mesh.size());
  job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        normal[v] = vertex_normal(mesh, position, static_cast<Index>(v));
  });
  return normal;
}

}  // namespace vcg_core::detail
