// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include <vcg/space/box2.h>
#include <vcg/space/point2.h>

namespace mesh_tools::io {
namespace {

using vcg::Point2d;
using vcg::Point3d;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// By Newell's formula; its length is twice the polygon's area.
Point3d normal_of(const std::vector<Point3d>& corners) {
  Point3d sum(0, 0, 0);
  for (std::size_t k = 2; k < corners.size(); ++k) sum += (corners[k - 1] - corners[0]) ^ (corners[k] - corners[0]);
  return sum;
}

Triangles fan(std::size_t corners) {
  Triangles triangles;
  for (std::uint32_t k = 2; k < corners; ++k) triangles.push_back({0, k - 1, k});
  return triangles;
}

/// Whether all triangles of the fan face the side of `normal`, but for slivers that rounding turns over.
bool is_fan(const std::vector<Point3d>& corners, const Point3d& normal) {
  double extent = 0;
  for (const Point3d& corner : corners) extent = std::max(extent, (corner - corners[0]).SquaredNorm());
  const double tolerance = 2e-7 * extent * normal.Norm();
  for (std::size_t k = 2; k < corners.size(); ++k)
    if (((corners[k - 1] - corners[0]) ^ (corners[k] - corners[0])) * normal < -tolerance) return false;
  return true;
}

/// Twice the signed area of a triangle.
double area(const Point2d& a, const Point2d& b, const Point2d& c) { return (b - a) ^ (c - a); }

/// Finds points in boxes.
class Grid {
 public:
  Grid(const std::vector<Point2d>& points, const std::vector<std::uint32_t>& which) {
    for (const Point2d& point : points) box_.Add(point);
    cells_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(which.size()))));
    content_.resize(cells_ * cells_);
    for (const std::uint32_t i : which) content_[cell(points[i], 1) * cells_ + cell(points[i], 0)].push_back(i);
  }

  /// Whether `is` holds for one of the points in the box, and perhaps some beside it.
  template <class Is>
  bool any(const vcg::Box2d& box, const Is& is) {
    for (std::size_t y = cell(box.min, 1); y <= cell(box.max, 1); ++y)
      for (std::size_t x = cell(box.min, 0); x <= cell(box.max, 0); ++x)
        for (const std::uint32_t i : content_[y * cells_ + x])
          if (is(i)) return true;
    return false;
  }

 private:
  std::size_t cell(const Point2d& point, int axis) const {
    const double extent = box_.max[axis] - box_.min[axis];
    if (!(extent > 0)) return 0;
    const double at = (point[axis] - box_.min[axis]) / extent * static_cast<double>(cells_);
    return std::min(cells_ - 1, static_cast<std::size_t>(std::max(0.0, at)));
  }

  vcg::Box2d box_;
  std::size_t cells_;
  std::vector<std::vector<std::uint32_t>> content_;
};

/// The ring of corners that are left, from which ears are cut.
class Ears {
 public:
  explicit Ears(const std::vector<Point2d>& points)
      : points_(points), next_(points.size()), last_(points.size()), is_left_(points.size(), true) {
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      next_[i] = (i + 1) % count;
      last_[i] = (i + count - 1) % count;
    }
  }

  Triangles cut() {
    std::vector<std::uint32_t> not_convex;
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      if (!is_convex(i)) not_convex.push_back(i);
    Grid grid(points_, not_convex);
    // The second time, for polygons that cross or touch themselves, points on a rim are no longer in the way.
    for (const bool open : {false, true}) {
      std::deque<std::uint32_t> candidates;
      for (std::uint32_t i = 0; i < points_.size(); ++i)
        if (is_left_[i]) candidates.push_back(i);
      while (!candidates.empty() && triangles_.size() + 2 < points_.size()) {
        const std::uint32_t ear = candidates.front();
        candidates.pop_front();
        if (!is_left_[ear] || !is_ear(ear, grid, open)) continue;
        remove(ear);
        // Whether another corner is an ear changes with its neighbours only.
        candidates.push_back(last_[ear]);
        candidates.push_back(next_[ear]);
      }
    }
    for (std::uint32_t i = 0; triangles_.size() + 2 < points_.size(); ++i)
      if (is_left_[i]) remove(i);
    return std::move(triangles_);
  }

 private:
  bool is_convex(std::uint32_t i) const { return area(points_[last_[i]], points_[i], points_[next_[i]]) > 0; }

  bool is_ear(std::uint32_t i, Grid& grid, bool open) const {
    if (!is_convex(i)) return false;
    const Point2d &a = points_[last_[i]], &b = points_[i], &c = points_[next_[i]];
    vcg::Box2d box;
    for (const Point2d* point : {&a, &b, &c}) box.Add(*point);
    return !grid.any(box, [&](std::uint32_t other) {
      const Point2d& p = points_[other];
      if (!is_left_[other] || p == a || p == b || p == c) return false;
      const double least = std::min({area(a, b, p), area(b, c, p), area(c, a, p)});
      return open ? least > 0 : least >= 0;
    });
  }

  void remove(std::uint32_t ear) {
    triangles_.push_back({last_[ear], ear, next_[ear]});
    next_[last_[ear]] = next_[ear];
    last_[next_[ear]] = last_[ear];
    is_left_[ear] = false;
  }

  const std::vector<Point2d>& points_;
  std::vector<std::uint32_t> next_, last_;
  std::vector<bool> is_left_;
  Triangles triangles_;
};

}  // namespace

Triangles triangulate(const std::vector<Point3d>& corners) {
  if (corners.size() <= 3) return fan(corners.size());
  const Point3d normal = normal_of(corners);
  const double length = normal.Norm();
  if (!(length > 0) || !std::isfinite(length) || is_fan(corners, normal)) return fan(corners.size());
  // Seen along the axis that is nearest to the normal, coordinates stay as exact as they are.
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  int first = (axis + 1) % 3, second = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(first, second);
  std::vector<Point2d> points;
  points.reserve(corners.size());
  for (const Point3d& corner : corners)
    points.emplace_back(corner[first] - corners[0][first], corner[second] - corners[0][second]);
  return Ears(points).cut();
}

}  // namespace mesh_tools::io
