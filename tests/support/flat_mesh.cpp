#include <support/flat_mesh.h>

#include <algorithm>
#include <set>
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
