// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/commit_positions.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesh/rows.h"
#include "power_of_two.h"

namespace vcg_core::detail {

namespace {

/// Fetches memory that is about to be written. The caller's order is not ours: each vertex would be a cache miss to
/// wait for.
void prefetch(const void* address) {
#ifdef __GNUC__
  __builtin_prefetch(address, 1);
#else
  (void)address;
#endif
}

/// Moves a copy of a vertex from `before` to `after`, given that the vertex itself goes from `from` to `to`; whether it
/// is somewhere else now.
template <class Real>
bool move_copy(char* row, const Vec3& from, const Vec3& to) {
  const Vec3 before = load_point<Real>(row);
  const Vec3 after = before == from ? to : Vec3(before + (to - from));
  const Real stored[3] = {static_cast<Real>(after[0]), static_cast<Real>(after[1]), static_cast<Real>(after[2])};
  for (const Real x : stored)
    if (!std::isfinite(x)) return false;
  if (load_point<Real>(reinterpret_cast<const char*>(stored)) == before) return false;
  std::memcpy(row, stored, sizeof stored);
  return true;
}

template <class Real>
void commit(const MeshArrays& mesh, const Array<Vec3>& position, const RealRows& rows, SmoothingReport& report) {
  constexpr std::size_t ahead = 32;
  const PowerOfTwo to_host(-mesh.exponent);
  double sum_of_squares = 0;  // in units of `position`: no square over- or underflows there
  double largest_square = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (i + ahead < position.size())
      prefetch(row_of(rows.data, rows.stride, mesh.host_vertex[mesh.first_copy(i + ahead)]));
    if (position[i] == mesh.position[i]) continue;
    const Vec3 from = to_host * mesh.position[i];
    const Vec3 to = to_host * position[i];
    std::size_t moved = 0;
    for (std::size_t k = mesh.first_copy(i); k < mesh.first_copy(i + 1); ++k)
      moved += move_copy<Real>(row_of(rows.data, rows.stride, mesh.host_vertex[k]), from, to);
    moved = std::min(moved, mesh.counted(i));
    if (moved == 0) continue;
    const double square = (position[i] - mesh.position[i]).squaredNorm();
    report.moved_vertices += moved;
    sum_of_squares += static_cast<double>(moved) * square;
    largest_square = std::max(largest_square, square);
  }
  if (report.moved_vertices == 0) return;
  report.max_displacement = to_host * std::sqrt(largest_square);
  report.rms_displacement = to_host * std::sqrt(sum_of_squares / static_cast<double>(report.moved_vertices));
}

}  // namespace

void commit_positions(const MeshArrays& mesh, const Array<Vec3>& position, const MeshView& view,
                      SmoothingReport& report) {
  if (view.positions.type == RealType::float32)
    commit<float>(mesh, position, view.positions, report);
  else
    commit<double>(mesh, position, view.positions, report);
}

}  // namespace vcg_core::detail
