// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay.h"

namespace mesh_tools::shapes {

/// What closed polygons enclose, by the even-odd rule, with quick answers for many points.
class Region {
 public:
  explicit Region(const std::vector<std::vector<Point2>>& loops);

  bool contains(const Point2& p) const;
  /// Whether a boundary edge passes within `distance` of p; distance must not exceed longest_edge().
  bool is_near_boundary(const Point2& p, double distance) const;

  double longest_edge() const { return cell_; }
  const Point2& low() const { return low_; }
  const Point2& high() const { return high_; }

 private:
  struct Edge {
    Point2 a, b;
  };
  int row_of(double y) const;
  int column_of(double x) const;

  std::vector<Edge> edges_;
  Point2 low_, high_;
  double cell_ = 0;
  int rows_ = 0, columns_ = 0;
  std::vector<std::vector<int>> by_row_;   // edges that meet a row of cells
  std::vector<std::vector<int>> by_cell_;  // edges whose box meets a cell
};

}  // namespace mesh_tools::shapes
