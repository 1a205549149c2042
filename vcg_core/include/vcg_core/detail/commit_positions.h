#pragma once

#include <algorithm>
#include <cmath>

#include <vcg_core/detail/mesh_arrays.h>
#include <vcg_core/detail/power_of_two.h>
#include <vcg_core/smoothing_report.h>

namespace vcg_core::detail {

/// Writes the new positions into the caller's mesh and counts what moved. Nothing here can fail: the step is all or
/// nothing. A coordinate that the mesh's own type could not hold stays as it was.
template <class Mesh>
void commit_positions(const MeshArrays& arrays, const Array<Vec3>& position, Mesh& mesh, SmoothingReport& report) {
  using Scalar = typename Mesh::ScalarType;
  const PowerOfTwo to_host(-arrays.exponent);
  double sum_of_squares = 0;  // in units of `position`: no square over- or underflows there
  double largest_square = 0;
  // The caller's order is not ours: each vertex would be a cache miss to wait for if it were not fetched ahead of time.
  constexpr std::size_t ahead = 32;
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (i + ahead < position.size()) __builtin_prefetch(&mesh.vert[arrays.host_vertex[i + ahead]].P(), 1);
    if (position[i] == arrays.position[i]) continue;
    const Vec3 to = to_host * position[i];
    const typename Mesh::CoordType stored(static_cast<Scalar>(to[0]), static_cast<Scalar>(to[1]),
                                          static_cast<Scalar>(to[2]));
    auto& p = mesh.vert[arrays.host_vertex[i]].P();
    if (!std::isfinite(stored[0]) || !std::isfinite(stored[1]) || !std::isfinite(stored[2]) || stored == p) continue;
    p = stored;
    const double square = (position[i] - arrays.position[i]).squaredNorm();
    ++report.moved_vertices;
    sum_of_squares += square;
    largest_square = std::max(largest_square, square);
  }
  if (report.moved_vertices == 0) return;
  report.max_displacement = to_host * std::sqrt(largest_square);
  report.rms_displacement = to_host * std::sqrt(sum_of_squares / static_cast<double>(report.moved_vertices));
}

}  // namespace vcg_core::detail
