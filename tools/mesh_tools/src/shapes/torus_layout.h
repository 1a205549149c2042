// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace mesh_tools::shapes {

/// The vertices of a torus in rows around the tube, every second one shifted by half a step, so that the triangles are
/// nearly equilateral. Rows are numbered on from the last to the first, and so are columns.
class TorusLayout {
 public:
  explicit TorusLayout(std::size_t vertices) {
    const double count = static_cast<double>(vertices);
    const double spacing = std::sqrt(4 * pi * pi * major * minor / (std::sqrt(0.75) * count));
    rows = 2 * std::max(2, static_cast<int>(std::lround(pi * minor / (std::sqrt(0.75) * spacing))));
    columns = std::max(3, static_cast<int>(std::lround(count / rows)));
  }

  std::array<double, 3> point(int row, int column) const {
    const double v = 2 * pi * row / rows, r = major + minor * std::cos(v);
    const double u = 2 * pi * (column + 0.5 * (row % 2)) / columns;
    return {r * std::cos(u), r * std::sin(u), minor * std::sin(v)};
  }

  /// The two faces above the edge from a vertex to the next one in its row.
  std::array<std::array<int, 3>, 2> faces(int row, int column) const {
    const int shift = row % 2;
    return {{{index(row, column), index(row, column + 1), index(row + 1, column + shift)},
             {index(row, column + 1), index(row + 1, column + 1 + shift), index(row + 1, column + shift)}}};
  }

  int rows, columns;

 private:
  static constexpr double pi = 3.14159265358979323846, major = 1, minor = 0.4;
  int index(int row, int column) const { return (row % rows) * columns + column % columns; }
};

}  // namespace mesh_tools::shapes
