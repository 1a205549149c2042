// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/mesh_census.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace test_support {

namespace {

using LongPoint = vcg::Point3<long double>;

bool is_triangle(const Triangle& f) { return f[0] != f[1] && f[1] != f[2] && f[2] != f[0]; }

/// Less height than 1e-12 of the longest edge is what rounding makes of none.
bool has_area(const FlatMesh& mesh, const Triangle& f) {
  const auto at = [&](int k) { return LongPoint::Construct(mesh.points[f[k]]); };
  const LongPoint a = at(1) - at(0);
  const LongPoint b = at(2) - at(0);
  return std::sqrt((a ^ b).SquaredNorm()) >
         1e-12L * std::max({a.SquaredNorm(), b.SquaredNorm(), (b - a).SquaredNorm()});
}

}  // namespace

MeshCensus take_census(const FlatMesh& split) {
  const FlatMesh mesh = welded(split);
  const std::vector<std::size_t> first = first_in_place(split);
  MeshCensus census;
  std::map<std::pair<std::size_t, std::size_t>, int> faces_of_edge;
  std::vector<char> has_face(mesh.points.size(), 0);
  for (const Triangle& f : mesh.faces) {
    if (!is_triangle(f) || !has_area(mesh, f)) ++census.degenerate_faces;
    if (!is_triangle(f)) continue;
    for (int k = 0; k < 3; ++k) {
      has_face[f[k]] = 1;
      ++faces_of_edge[std::minmax({f[k], f[(k + 1) % 3]})];
    }
  }
  std::vector<char> border(mesh.points.size(), 0);
  std::vector<char> non_manifold(mesh.points.size(), 0);
  for (const auto& [edge, faces] : faces_of_edge)
    for (const std::size_t v : {edge.first, edge.second}) {
      if (faces == 1) border[v] = 1;
      if (faces > 2) non_manifold[v] = 1;
    }
  std::vector<std::size_t> copies(mesh.points.size(), 0);
  for (const std::size_t v : first) ++copies[v];
  for (const std::size_t n : copies)
    if (n > 1) census.coincident += n;
  const auto count = [&](const std::vector<char>& marks, char mark) {
    return static_cast<std::size_t>(
        std::count_if(first.begin(), first.end(), [&](std::size_t v) { return marks[v] == mark; }));
  };
  census.isolated = count(has_face, 0);
  census.border = count(border, 1);
  census.non_manifold = count(non_manifold, 1);
  return census;
}

}  // namespace test_support
