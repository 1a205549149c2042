// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/result_census.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_support {

namespace {

using LongPoint = vcg::Point3<long double>;

long double length(const LongPoint& p) { return std::sqrt(p * p); }

LongPoint edge(const FlatMesh& mesh, std::size_t from, std::size_t to) {
  return LongPoint::Construct(mesh.points[to]) - LongPoint::Construct(mesh.points[from]);
}

bool repeats(const Triangle& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

/// The normal of a face, with twice its area as length; zero where its height is less than 1e-12 of its longest edge.
LongPoint normal(const FlatMesh& mesh, const Triangle& f) {
  const LongPoint cross = edge(mesh, f[0], f[1]) ^ edge(mesh, f[0], f[2]);
  const long double longest =
      std::max({length(edge(mesh, f[0], f[1])), length(edge(mesh, f[1], f[2])), length(edge(mesh, f[2], f[0]))});
  return length(cross) > 1e-12L * longest * longest ? cross : LongPoint(0, 0, 0);
}

}  // namespace

ResultCensus take_census(const FlatMesh& split, const FlatMesh& after) {
  const FlatMesh before = welded(split);
  const std::vector<std::size_t> first = first_in_place(split);
  ResultCensus census;
  std::vector<long double> longest(before.points.size(), -1);
  for (const Triangle& f : before.faces) {
    census.flipped_faces += normal(before, f) * normal(after, f) < 0;
    if (repeats(f)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = f[k], b = f[(k + 1) % 3];
      const long double l = length(edge(before, a, b));
      longest[a] = std::max(longest[a], l);
      longest[b] = std::max(longest[b], l);
    }
  }
  const long double e = average_edge_length(before);
  for (std::size_t v = 0; v < before.points.size(); ++v) {
    if (longest[first[v]] < 0) continue;  // no face
    const long double moved = length(LongPoint::Construct(after.points[v]) - LongPoint::Construct(before.points[v]));
    census.far_moved_vertices += moved > 2 * e;
    census.beyond_ring_vertices += moved > longest[first[v]];
  }
  return census;
}

}  // namespace test_support
