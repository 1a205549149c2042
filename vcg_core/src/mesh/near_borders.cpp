// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/near_borders.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "job.h"
#include "point_grid.h"
#include "volume.h"

namespace vcg_core::detail {

namespace {

constexpr double part_of_diagonal = 1e-5;
constexpr double part_of_edge = 0.1;
/// Points that one search may look at in the mean: with more, there are many edges as short, and nothing to be said.
constexpr std::size_t most_looks = 200;
constexpr std::size_t looks_between_polls = std::size_t(1) << 20;

double shortest_edge_squared(const MeshArrays& mesh, Index v) {
  double shortest = std::numeric_limits<double>::infinity();
  for (Index s = mesh.topology.star_begin[v]; s < mesh.topology.star_begin[v + 1]; ++s)
    for (const Index corner : {next_in_face(mesh.topology.star[s]), previous_in_face(mesh.topology.star[s])})
      shortest = std::min(shortest, (mesh.position[vertex_of(mesh, corner)] - mesh.position[v]).squaredNorm());
  return shortest;
}

}  // namespace

NearBorders find_near_borders(const MeshArrays& mesh, Job& job) {
  if (mesh.topology.border_vertices == 0) return {};
  Array<Index> border;
  job.serial(mesh.size(), [&](std::size_t v) {
    if (mesh.topology.border[v]) border.push_back(static_cast<Index>(v));
  });
  const double diagonal = box_of_whole(mesh, job).diagonal().norm();
  const double radius = std::min(part_of_diagonal * diagonal, part_of_edge * mesh.topology.average_edge_length);
  const PointGrid grid(mesh.position, border, radius, &job);
  PointGrid::Search search(grid);
  NearBorders found;
  double largest_square = 0;
  bool too_many = false;
  std::size_t looks_at_poll = 0;
  job.serial(border.size(), [&](std::size_t k) {
    if (too_many) return;
    const Index v = border[k];
    const double limit = part_of_edge * part_of_edge * shortest_edge_squared(mesh, v);
    bool is_near = false;
    search.for_each_near(mesh.position[v], [&](Index w, const Vec3& other) {
      const double square = (other - mesh.position[v]).squaredNorm();
      if (w == v || square > limit) return;
      is_near = true;
      largest_square = std::max(largest_square, square);
    });
    if (is_near) found.vertices += mesh.counted(v);
    too_many = search.looks() / most_looks > border.size();
    if (search.looks() - looks_at_poll > looks_between_polls) {
      job.poll();
      looks_at_poll = search.looks();
    }
  });
  if (too_many) return {};
  found.distance = std::sqrt(largest_square);
  return found;
}

}  // namespace vcg_core::detail
