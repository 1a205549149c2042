// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <mesh_tools/random.h>

#include "delaunay.h"
#include "families.h"
#include "patch.h"

namespace mesh_tools::shapes {
namespace {

/// Grid of n x n vertices over the unit square; is_slash(column, row) chooses a cell's diagonal.
template <class Choice>
void make_grid(std::size_t vertices, Choice is_slash, Mesh& mesh) {
  const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(static_cast<double>(vertices)))));
  std::vector<vcg::Point3d> points;
  std::vector<std::array<int, 3>> triangles;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      points.emplace_back(static_cast<double>(column) / (n - 1), static_cast<double>(row) / (n - 1), 0.0);
  for (int row = 0; row + 1 < n; ++row) {
    for (int column = 0; column + 1 < n; ++column) {
      const int a = row * n + column, b = a + 1, c = b + n, d = a + n;
      if (is_slash(column, row)) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  }
  fill_mesh(points, triangles, mesh);
}

}  // namespace

void make_plane_slash(std::size_t vertices, Mesh& mesh) {
  make_grid(
      vertices, [](int, int) { return true; }, mesh);
}

void make_plane_backslash(std::size_t vertices, Mesh& mesh) {
  make_grid(
      vertices, [](int, int) { return false; }, mesh);
}

void make_plane_alternating(std::size_t vertices, Mesh& mesh) {
  make_grid(
      vertices, [](int column, int row) { return (column + row) % 2 == 0; }, mesh);
}

void make_plane_random_diagonals(std::size_t vertices, Mesh& mesh) {
  Random random(1);
  make_grid(
      vertices, [&](int, int) { return random.uniform() < 0.5; }, mesh);
}

void make_plane_delaunay(std::size_t vertices, Mesh& mesh) {
  // The border is sampled evenly, so that the hull has no slivers; all coordinates lie on the grid of delaunay().
  const int side = std::max(1, static_cast<int>(std::lround(0.9 * std::sqrt(static_cast<double>(vertices)))));
  const auto on_grid = [](double value) { return std::ldexp(std::floor(std::ldexp(value, 29)), -29); };
  std::vector<Point2> points;
  for (int i = 0; i < side; ++i) {
    const double s = on_grid(static_cast<double>(i) / side);
    points.insert(points.end(), {{s, 0}, {1, s}, {1 - s, 1}, {0, 1 - s}});
  }
  Random random(2);
  while (points.size() < vertices) {
    const double x = on_grid(random.uniform()), y = on_grid(random.uniform());
    if (x > 0 && y > 0) points.push_back({x, y});
  }
  const Triangulation triangulation = delaunay(points);
  std::vector<vcg::Point3d> places;
  places.reserve(points.size());
  for (const Point2& p : points) places.emplace_back(p.x, p.y, 0.0);
  fill_mesh(places, triangulation.triangles, mesh);
}

}  // namespace mesh_tools::shapes
