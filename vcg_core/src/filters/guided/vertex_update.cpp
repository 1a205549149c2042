// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_update.h"

#include <Eigen/Geometry>

#include "face_geometry.h"
#include "job.h"
#include "polled_copy.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;

/// The plane that a face is to lie in: through its centroid as it lies now, along its filtered normal.
struct Plane {
  Eigen::Vector3f normal;
  double offset;  ///< three times that of the centroid: n . (a + b + c)
};

/// @param use  is called with each face and its normal
template <class Use>
void measure_offsets(const MeshArrays& mesh, const Array<Vec3>& position, Array<Plane>& plane, Job& job,
                     const Use& use) {
  job.parallel(mesh.face.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const auto& v = mesh.face[f];
        const Vec3 normal = plane[f].normal.cast<double>();
        plane[f].offset = normal.dot(position[v[0]] + position[v[1]] + position[v[2]]);
        use(f, normal);
      }
  });
}

/// Measures offsets, and marks the vertices of folded faces.
void find_folds(const MeshArrays& mesh, const Array<Vec3>& position, double cosine, Array<Plane>& plane,
                Array<std::uint8_t>& folded, Job& job) {
  Array<std::uint8_t> face_folded(mesh.face.size());
  measure_offsets(mesh, position, plane, job, [&](std::size_t f, const Vec3& normal) {
    const Vec3 cross = area_vector(mesh, position, f);
    face_folded[f] = cross.dot(normal) < cosine * cross.norm();
  });
  folded.assign(mesh.size(), 0);
  job.serial(mesh.face.size(), [&](std::size_t f) {
    if (face_folded[f])
      for (const Index v : mesh.face[f]) folded[v] = 1;
  });
}

Vec3 step_to_planes(const MeshArrays& mesh, const Array<Plane>& plane, const Vec3& position, Index v) {
  const MeshTopology& topology = mesh.topology;
  const Vec3 thrice = 3 * position;
  Vec3 sum = Vec3::Zero();
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Plane& p = plane[topology.star[s] / 3];
    const Vec3 normal = p.normal.cast<double>();
    sum += normal * (p.offset - normal.dot(thrice));
  }
  return sum / (3.0 * (topology.star_begin[v + 1] - topology.star_begin[v]));
}

/// The displacement to the middle of the ring, less its part along the normals of the faces.
Vec3 step_within_surface(const MeshArrays& mesh, const Array<UnitNormal>& normal, const Array<Vec3>& position,
                         Index v) {
  const MeshTopology& topology = mesh.topology;
  const double count = topology.star_begin[v + 1] - topology.star_begin[v];
  Vec3 to_middle = Vec3::Zero();
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Index corner = topology.star[s];
    to_middle += position[vertex_of(mesh, next_in_face(corner))] + position[vertex_of(mesh, previous_in_face(corner))] -
                 2 * position[v];
  }
  to_middle /= 2 * count;
  Vec3 along_normals = Vec3::Zero();
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Vec3 n = in_double(normal[topology.star[s] / 3]);
    along_normals += n * n.dot(to_middle);
  }
  return to_middle - along_normals / count;
}

}  // namespace

void update_positions(const MeshArrays& mesh, const Array<UnitNormal>& normal, const Array<std::uint8_t>& movable,
                      int updates, const GuidedSettings& settings, Array<Vec3>& position, Job& job) {
  Array<std::uint8_t> folded(mesh.size(), 0);
  Array<Vec3> moved = polled_copy(position, job);
  Array<Plane> plane(mesh.face.size());
  job.serial(plane.size(), [&](std::size_t f) { plane[f].normal = normal[f].head<3>(); });
  for (int update = 0; update < updates; ++update) {
    if (settings.unfold && update % settings.updates_between_fold_checks == 0)
      find_folds(mesh, position, settings.fold_cosine, plane, folded, job);
    else
      measure_offsets(mesh, position, plane, job, [](std::size_t, const Vec3&) {});
    job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (auto v = static_cast<Index>(chunks.begin()); v < chunks.end(); ++v) {
          if (!movable[v]) continue;
          moved[v] = position[v] + step_to_planes(mesh, plane, position[v], v);
          if (folded[v] && !mesh.topology.border[v] && !mesh.topology.is_on_crease(v))
            moved[v] += settings.unfold_step * step_within_surface(mesh, normal, position, v);
        }
    });
    position.swap(moved);
  }
}

}  // namespace vcg_core::detail
