// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <vcg_core/errors.h>

#include "geodesic_march.h"
#include "job.h"
#include "triangle_frames.h"

namespace vcg_core::detail {

namespace {

/// Gain, in |e|, that opens a settled vertex again. Well below what rounding leaves after a hundred edges.
constexpr double tolerance = 1e-12;

}  // namespace

std::vector<double> geodesic_field(const MeshArrays& mesh, std::size_t host_source, Job& job) {
  const Array<Index> index_of = vertex_of_host(mesh);
  if (host_source >= index_of.size() || index_of[host_source] == mesh.size())
    throw InvalidParameter("start vertex is " + std::to_string(host_source) +
                           "; it must be the index of a vertex of the mesh, 0 to " +
                           std::to_string(index_of.size() - 1));
  job.begin_stage("Measuring distances", 1.0);
  using Scalar = long double;
  const FramesOnDemand frames(mesh);
  GeodesicMarch<Scalar, FramesOnDemand> march(mesh, frames, tolerance * mesh.topology.average_edge_length);
  const double vertices = static_cast<double>(mesh.size());
  march.run(index_of[host_source], std::numeric_limits<Scalar>::infinity(),
            [&](std::size_t settled) { job.report(std::min(1.0, static_cast<double>(settled) / vertices)); });
  job.finish();

  std::vector<double> distance(mesh.host_vertex_count, std::numeric_limits<double>::infinity());
  for (const Index v : march.reached()) {
    const auto to_v = static_cast<double>(std::ldexp(march.distance(v), -mesh.exponent));
    for (std::size_t k = mesh.first_copy(v); k < mesh.first_copy(v + 1); ++k) distance[mesh.host_vertex[k]] = to_v;
  }
  return distance;
}

}  // namespace vcg_core::detail
