// SPDX-License-Identifier: GPL-3.0-or-later
#include "region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesh_tools::shapes {
namespace {

double squared_distance(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
  const double x = a.x + t * dx - p.x, y = a.y + t * dy - p.y;
  return x * x + y * y;
}

}  // namespace

Region::Region(const std::vector<std::vector<Point2>>& loops) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  low_ = {infinity, infinity};
  high_ = {-infinity, -infinity};
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      edges_.push_back({a, b});
      cell_ = std::max(cell_, std::hypot(b.x - a.x, b.y - a.y));
      low_ = {std::min(low_.x, a.x), std::min(low_.y, a.y)};
      high_ = {std::max(high_.x, a.x), std::max(high_.y, a.y)};
    }
  }
  rows_ = static_cast<int>((high_.y - low_.y) / cell_) + 1;
  columns_ = static_cast<int>((high_.x - low_.x) / cell_) + 1;
  by_row_.resize(rows_);
  by_cell_.resize(static_cast<std::size_t>(rows_) * columns_);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const int first_row = row_of(std::min(edge.a.y, edge.b.y)), last_row = row_of(std::max(edge.a.y, edge.b.y));
    const int first = column_of(std::min(edge.a.x, edge.b.x)), last = column_of(std::max(edge.a.x, edge.b.x));
    for (int row = first_row; row <= last_row; ++row) {
      by_row_[row].push_back(static_cast<int>(i));
      for (int column = first; column <= last; ++column)
        by_cell_[static_cast<std::size_t>(row) * columns_ + column].push_back(static_cast<int>(i));
    }
  }
}

int Region::row_of(double y) const { return std::clamp(static_cast<int>((y - low_.y) / cell_), 0, rows_ - 1); }
int Region::column_of(double x) const { return std::clamp(static_cast<int>((x - low_.x) / cell_), 0, columns_ - 1); }

bool Region::contains(const Point2& p) const {
  if (p.y < low_.y || p.y > high_.y) return false;
  bool inside = false;
  for (int i : by_row_[row_of(p.y)]) {
    const Point2 &a = edges_[i].a, &b = edges_[i].b;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

bool Region::is_near_boundary(const Point2& p, double distance) const {
  const int row = row_of(p.y), column = column_of(p.x);
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c)
      for (int i : by_cell_[static_cast<std::size_t>(r) * columns_ + c])
        if (squared_distance(p, edges_[i].a, edges_[i].b) < distance * distance) return true;
  return false;
}

}  // namespace mesh_tools::shapes
