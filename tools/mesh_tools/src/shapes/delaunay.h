// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace mesh_tools::shapes {

struct Point2 {
  double x = 0;
  double y = 0;
};

struct Triangulation {
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise, indices into the points
  /// neighbours[t][k]: the triangle beyond the edge opposite to vertex k of t; -1 outside the convex hull
  std::vector<std::array<int, 3>> neighbours;
};

/// Delaunay triangulation of the convex hull of `points`, by incremental insertion (Bowyer 1981, Watson 1981).
/// Decisions are exact: they are made in integers, on the points snapped to a grid of 2^30 cells over the larger side
/// of their bounding box. The result is the same on every platform.
/// @throws std::invalid_argument if two points share a grid cell or all lie on a line
Triangulation delaunay(const std::vector<Point2>& points);

}  // namespace mesh_tools::shapes
