// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <vector>

#include "delaunay.h"
#include "families.h"
#include "patch.h"

namespace mesh_tools::shapes {

/// Points on a Fibonacci spiral and the north pole. Projecting from the pole to a plane keeps circles, so a Delaunay
/// triangulation there is one on the sphere; the pole closes it.
void make_sphere(std::size_t vertices, Mesh& mesh) {
  const int n = static_cast<int>(vertices);
  const double golden_angle = 3.14159265358979323846 * (3 - std::sqrt(5.0));
  std::vector<vcg::Point3d> points;
  std::vector<Point2> projected;
  for (int k = 0; k + 1 < n; ++k) {
    const double below_pole = 2 - (2.0 * k + 1) / n;  // 1 - z
    const double radius = std::sqrt(below_pole * (2 - below_pole));
    const double x = radius * std::cos(golden_angle * k), y = radius * std::sin(golden_angle * k);
    points.emplace_back(x, y, 1 - below_pole);
    projected.push_back({x / below_pole, y / below_pole});
  }
  const int pole = n - 1;
  points.emplace_back(0.0, 0.0, 1.0);
  const Triangulation plane = delaunay(projected);
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) {
    const auto& v = plane.triangles[t];
    triangles.push_back({v[0], v[2], v[1]});  // seen from the pole the inside is outside
    for (int k = 0; k < 3; ++k)
      if (plane.neighbours[t][k] < 0) triangles.push_back({v[(k + 1) % 3], v[(k + 2) % 3], pole});
  }
  fill_mesh(points, triangles, mesh);
}

}  // namespace mesh_tools::shapes
