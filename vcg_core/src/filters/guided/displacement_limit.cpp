// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacement_limit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "job.h"
#include "polled_copy.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;

/// After this many halvings a vertex goes back altogether, so that the search for turned faces ends.
constexpr std::uint8_t most_halvings = 6;

/// Just short of the longest edge, so that no rounding carries a vertex beyond its ring.
constexpr double within_ring = 0.999;

/// Whether noise that moves the vertices by up to their limits can have turned a face over.
bool can_have_turned(const std::array<Index, 3>& face, const Array<Vec3>& position, const Array<double>& limit,
                     double double_area) {
  double longest = 0;
  double farthest = 0;
  for (int k = 0; k < 3; ++k) {
    longest = std::max(longest, (position[face[(k + 1) % 3]] - position[face[k]]).norm());
    farthest = std::max(farthest, limit[face[k]]);
  }
  return farthest * longest >= double_area;  // limit against the least altitude
}

Vec3 area_vector(const std::array<Index, 3>& face, const Array<Vec3>& position) {
  const Vec3& a = position[face[0]];
  return (position[face[1]] - a).cross(position[face[2]] - a);
}

}  // namespace

Array<double> displacement_limits(const MeshArrays& mesh, const Array<double>& noise, double deviations, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<double> limit(mesh.size());
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        double longest = 0;
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s)
          for (const Index corner : {next_in_face(topology.star[s]), previous_in_face(topology.star[s])})
            longest = std::max(longest, (mesh.position[vertex_of(mesh, corner)] - mesh.position[v]).squaredNorm());
        limit[v] = std::min(deviations * noise[v], within_ring * std::sqrt(longest));
      }
  });
  return limit;
}

bool limit_displacement(const Vec3& from, double limit, Vec3& position) {
  const Vec3 displacement = position - from;
  const double length = displacement.norm();
  if (length <= limit) return false;
  position = limit > 0 ? Vec3(from + displacement * (limit / length)) : from;
  return true;
}

void limit_displacements(const Array<Vec3>& from, const Array<double>& limit, Array<Vec3>& position,
                         Array<std::uint8_t>& bounded, Job& job) {
  job.parallel(from.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        if (limit_displacement(from[v], limit[v], position[v])) bounded[v] = 1;
  });
}

void keep_faces_upright(const MeshArrays& mesh, const Array<Vec3>& from, const Array<UnitNormal>& normal,
                        const Array<double>& limit, Array<Vec3>& position, Array<std::uint8_t>& bounded, Job& job) {
  const Array<Vec3> wanted = polled_copy(position, job);
  Array<std::uint8_t> halvings(mesh.size(), 0);
  Array<std::uint8_t> turned(mesh.face.size());
  Array<Index> to_take_back;
  do {
    job.parallel(mesh.face.size(), grain, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
          const Vec3 before = area_vector(mesh.face[f], from);
          const Vec3 after = area_vector(mesh.face[f], position);
          const bool was_upright =
              before.dot(in_double(normal[f])) > 0 || !can_have_turned(mesh.face[f], from, limit, before.norm());
          turned[f] = was_upright && !(after.dot(before) > 0);
        }
    });
    to_take_back.clear();
    job.serial(mesh.face.size(), [&](std::size_t f) {
      if (!turned[f]) return;
      for (const Index v : mesh.face[f])
        if (position[v] != from[v]) to_take_back.push_back(v);
    });
    std::sort(to_take_back.begin(), to_take_back.end());
    to_take_back.erase(std::unique(to_take_back.begin(), to_take_back.end()), to_take_back.end());
    for (const Index v : to_take_back) {
      bounded[v] = 1;
      ++halvings[v];
      position[v] = halvings[v] > most_halvings ? from[v] : Vec3(from[v] + (wanted[v] - from[v]) / (1 << halvings[v]));
    }
  } while (!to_take_back.empty());
}

}  // namespace vcg_core::detail
