// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay.h"

namespace mesh_tools::shapes {

/// A closed curve of lines and arcs in the plane, cut into smooth runs at its sharp corners. Material lies to its left:
/// counter-clockwise for an outer boundary, clockwise for a hole.
class Outline {
 public:
  /// Starts at a sharp corner (or anywhere, for a curve without corners).
  explicit Outline(const Point2& start) : current_(start) {}

  void line_to(const Point2& end);
  /// Arc around `centre` from the current point through `angle` radians, positive counter-clockwise.
  void arc(const Point2& centre, double angle);
  /// Marks the current point as a sharp corner: a smooth run ends, the next begins.
  void corner();

  /// Line to the corner, rounded off there with `radius`, and on towards `after`.
  void rounded_line_to(const Point2& vertex, const Point2& after, double radius);

  static Outline polygon(const std::vector<Point2>& vertices);
  static Outline circular_hole(const Point2& centre, double radius);

  std::size_t run_count() const { return runs_.size(); }
  double run_length(std::size_t run) const;
  /// The point at arc length s of a run.
  Point2 at(std::size_t run, double s) const;

 private:
  struct Piece {
    Point2 start, end, centre;
    double radius, first_angle, angle;  // radius 0: a line
    double length;
  };
  std::vector<std::vector<Piece>> runs_;
  Point2 current_;
  bool is_new_run_ = true;

  void append(const Piece& piece);
};

}  // namespace mesh_tools::shapes
