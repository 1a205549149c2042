// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "families.h"
#include "patch.h"

namespace mesh_tools::shapes {

/// Rows around the tube, every second one shifted by half a step, so that the triangles are nearly equilateral.
void make_torus(std::size_t vertices, Mesh& mesh) {
  constexpr double pi = 3.14159265358979323846, major = 1, minor = 0.4;
  const double count = static_cast<double>(vertices);
  const double spacing = std::sqrt(4 * pi * pi * major * minor / (std::sqrt(0.75) * count));
  const int rows = 2 * std::max(2, static_cast<int>(std::lround(pi * minor / (std::sqrt(0.75) * spacing))));
  const int columns = std::max(3, static_cast<int>(std::lround(count / rows)));
  std::vector<vcg::Point3d> points;
  std::vector<std::array<int, 3>> triangles;
  const auto index = [&](int row, int column) { return (row % rows) * columns + column % columns; };
  for (int row = 0; row < rows; ++row) {
    const double v = 2 * pi * row / rows, r = major + minor * std::cos(v);
    for (int column = 0; column < columns; ++column) {
      const double u = 2 * pi * (column + 0.5 * (row % 2)) / columns;
      points.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
      const int shift = row % 2;
      triangles.push_back({index(row, column), index(row, column + 1), index(row + 1, column + shift)});
      triangles.push_back({index(row, column + 1), index(row + 1, column + 1 + shift), index(row + 1, column + shift)});
    }
  }
  fill_mesh(points, triangles, mesh);
}

}  // namespace mesh_tools::shapes
