// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline.h"

#include <algorithm>
#include <cmath>

namespace mesh_tools::shapes {
namespace {
constexpr double pi = 3.14159265358979323846;
}

void Outline::append(const Piece& piece) {
  if (is_new_run_) runs_.emplace_back();
  is_new_run_ = false;
  runs_.back().push_back(piece);
  current_ = piece.end;
}

void Outline::line_to(const Point2& end) {
  append({current_, end, {}, 0, 0, 0, std::hypot(end.x - current_.x, end.y - current_.y)});
}

void Outline::arc(const Point2& centre, double angle) {
  const double x = current_.x - centre.x, y = current_.y - centre.y;
  const double radius = std::hypot(x, y), first = std::atan2(y, x);
  const Point2 end{centre.x + radius * std::cos(first + angle), centre.y + radius * std::sin(first + angle)};
  append({current_, end, centre, radius, first, angle, radius * std::abs(angle)});
}

void Outline::corner() { is_new_run_ = true; }

void Outline::rounded_line_to(const Point2& vertex, const Point2& after, double radius) {
  const auto direction = [](const Point2& from, const Point2& to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    return Point2{(to.x - from.x) / length, (to.y - from.y) / length};
  };
  const Point2 in = direction(current_, vertex), out = direction(vertex, after);
  const double turn = std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y);
  const double cut = radius * std::tan(std::abs(turn) / 2);
  line_to({vertex.x - cut * in.x, vertex.y - cut * in.y});
  const double side = turn > 0 ? radius : -radius;
  arc({current_.x - side * in.y, current_.y + side * in.x}, turn);
}

Outline Outline::polygon(const std::vector<Point2>& vertices) {
  Outline outline(vertices.front());
  for (std::size_t i = 1; i <= vertices.size(); ++i) {
    outline.line_to(vertices[i % vertices.size()]);
    outline.corner();
  }
  return outline;
}

Outline Outline::circular_hole(const Point2& centre, double radius) {
  Outline outline({centre.x + radius, centre.y});
  outline.arc(centre, -2 * pi);
  return outline;
}

double Outline::run_length(std::size_t run) const {
  double length = 0;
  for (const Piece& piece : runs_[run]) length += piece.length;
  return length;
}

Point2 Outline::at(std::size_t run, double s) const {
  const std::vector<Piece>& pieces = runs_[run];
  std::size_t i = 0;
  while (i + 1 < pieces.size() && s > pieces[i].length) s -= pieces[i++].length;
  const Piece& piece = pieces[i];
  const double t = std::clamp(s / piece.length, 0.0, 1.0);
  if (piece.radius > 0) {
    const double angle = piece.first_angle + t * piece.angle;
    return {piece.centre.x + piece.radius * std::cos(angle), piece.centre.y + piece.radius * std::sin(angle)};
  }
  return {piece.start.x + t * (piece.end.x - piece.start.x), piece.start.y + t * (piece.end.y - piece.start.y)};
}

}  // namespace mesh_tools::shapes
