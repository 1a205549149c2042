// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/flat_mesh.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace test_support {

FlatMesh transformed(FlatMesh mesh, const std::function<Point(const Point&)>& change) {
  for (Point& p : mesh.points) p = change(p);
  return mesh;
}

void append(FlatMesh& mesh, const FlatMesh& other) {
  const std::size_t offset = mesh.points.size();
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& f : other.faces) mesh.faces.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
}

std::vector<std::size_t> first_in_place(const FlatMesh& mesh) {
  std::map<std::tuple<double, double, double>, std::size_t> at;
  std::vector<std::size_t> first;
  for (const Point& p : mesh.points)
    first.push_back(at.emplace(std::tuple(p[0], p[1], p[2]), first.size()).first->second);
  return first;
}

FlatMesh welded(FlatMesh mesh) {
  const std::vector<std::size_t> first = first_in_place(mesh);
  for (Triangle& f : mesh.faces)
    for (std::size_t& v : f) v = first[v];
  return mesh;
}

double average_edge_length(const FlatMesh& mesh) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const Triangle& f : mesh.faces) {
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax({f[k], f[(k + 1) % 3]}));
  }
  double sum = 0;
  for (const auto& [a, b] : edges) sum += (mesh.points[a] - mesh.points[b]).Norm();
  return sum / static_cast<double>(edges.size());
}

}  // namespace test_support
