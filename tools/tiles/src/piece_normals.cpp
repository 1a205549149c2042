// SPDX-License-Identifier: GPL-3.0-or-later
#include "piece_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace tiles {
namespace {

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point& a) { return std::sqrt(dot(a, a)); }

Point point_at(const std::vector<double>& numbers, std::size_t v) {
  return {numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]};
}

/// What vertices at one place with one normal have in common.
struct Sum {
  Point normal{};
  bool moved = false;
};

/// For each of the tile's vertices the first one with the same place and the same normal.
std::vector<std::uint32_t> equal_ones(const std::vector<Point>& place, const std::vector<Point>& normal) {
  std::vector<std::uint32_t> order(place.size()), equal(place.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::uint32_t i) { return std::tie(place[i], normal[i]); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_next = i > 0 && key(order[i]) == key(order[i - 1]);
    equal[order[i]] = is_next ? equal[order[i - 1]] : order[i];
  }
  return equal;
}

}  // namespace

std::vector<Point> moved_normals(const LargeMesh& mesh, const std::vector<double>& before, const Piece& piece) {
  const std::vector<double> after = piece.positions();
  std::vector<std::uint32_t> number(piece.vertices());  // among the tile's own
  std::vector<Point> place, normal;
  for (std::size_t v = 0; v < piece.vertices(); ++v) {
    if (!piece.own_vertex[v]) continue;
    number[v] = static_cast<std::uint32_t>(place.size());
    normal.push_back(mesh.normal(piece.own_index[place.size()]));
    place.push_back(point_at(before, v));
  }
  const std::vector<std::uint32_t> equal = equal_ones(place, normal);
  std::vector<Sum> sum(place.size());
  for (const Face& face : piece.face) {
    const auto is_own = [&](std::uint32_t v) { return piece.own_vertex[v] != 0; };
    if (!std::any_of(face.begin(), face.end(), is_own)) continue;
    const Point corner[3] = {point_at(after, face[0]), point_at(after, face[1]), point_at(after, face[2])};
    const bool moved = std::any_of(face.begin(), face.end(),
                                   [&](std::uint32_t v) { return point_at(before, v) != point_at(after, v); });
    Point direction = cross(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
    const double twice_area = length(direction);
    for (double& x : direction) x = twice_area > 0 ? x / twice_area : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_own(face[k])) continue;
      const Point next = minus(corner[(k + 1) % 3], corner[k]), last = minus(corner[(k + 2) % 3], corner[k]);
      const double angle = std::atan2(length(cross(next, last)), dot(next, last));
      Sum& here = sum[equal[number[face[k]]]];
      here.moved |= moved;
      for (std::size_t i = 0; i < 3; ++i) here.normal[i] += angle * direction[i];
    }
  }
  constexpr double cancelled = 1e-12;  // faces that are opposite to each other leave rounding errors, no direction
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const Sum& all = sum[equal[i]];
    const double size = length(all.normal);
    if (!all.moved || !(size > cancelled)) continue;
    for (std::size_t k = 0; k < 3; ++k) normal[i][k] = all.normal[k] / size;
  }
  return normal;
}

}  // namespace tiles
