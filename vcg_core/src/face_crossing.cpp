// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "face_area.h"

namespace vcg_core::detail {

namespace {

/// Heights of the corners of a face over the plane of another; 0 where rounding could have made them.
using Heights = std::array<double, 3>;

Heights heights_over(const PlacedFace& plane, const PlacedFace& face, double rounding) {
  Heights heights{};
  for (int k = 0; k < 3; ++k) {
    const Index v = face.vertex[k];
    if (v == plane.vertex[0] || v == plane.vertex[1] || v == plane.vertex[2]) continue;
    const Vec3 d = face.corner[k] - plane.corner[0];
    const double height = plane.normal.dot(d);
    if (std::abs(height) > rounding * (1 + plane.tilt * d.norm())) heights[k] = height;
  }
  return heights;
}

bool on_both_sides(const Heights& h) { return std::min({h[0], h[1], h[2]}) < 0 && std::max({h[0], h[1], h[2]}) > 0; }

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// The piece of the line through `origin` along `direction` between the points where the face's outline meets the other
/// plane, which contains that line.
Interval piece_of_line(const PlacedFace& face, const Heights& height, const Vec3& origin, const Vec3& direction) {
  Interval piece;
  std::array<double, 3> along;
  for (int k = 0; k < 3; ++k) along[k] = direction.dot(face.corner[k] - origin);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (height[k] == 0) piece.add(along[k]);
    if ((height[k] < 0 && height[next] > 0) || (height[k] > 0 && height[next] < 0))
      piece.add(along[k] + (along[next] - along[k]) * (height[k] / (height[k] - height[next])));
  }
  return piece;
}

}  // namespace

PlacedFace place_face(const std::array<Index, 3>& vertex, const Array<Vec3>& position) {
  PlacedFace face{vertex, {position[vertex[0]], position[vertex[1]], position[vertex[2]]}};
  const Vec3 a = face.corner[1] - face.corner[0], b = face.corner[2] - face.corner[0];
  const Vec3 cross = a.cross(b);
  if (!has_area(a, b, cross)) return face;
  const double twice_area = cross.norm();
  face.normal = cross / twice_area;
  face.tilt = std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()})) / twice_area;
  return face;
}

bool faces_cross(const PlacedFace& a, const PlacedFace& b, double rounding) {
  if (a.tilt == 0 || b.tilt == 0) return false;
  const Heights of_b = heights_over(a, b, rounding);
  if (!on_both_sides(of_b)) return false;
  const Heights of_a = heights_over(b, a, rounding);
  if (!on_both_sides(of_a)) return false;
  const Vec3 direction = a.normal.cross(b.normal);
  const double sine = direction.norm();
  if (sine == 0) return false;
  const Vec3& origin = a.corner[0];
  const Interval in_a = piece_of_line(a, of_a, origin, direction / sine);
  const Interval in_b = piece_of_line(b, of_b, origin, direction / sine);
  // An error of the heights moves the line by so much more, the flatter the planes meet.
  return std::min(in_a.high, in_b.high) - std::max(in_a.low, in_b.low) > rounding / sine;
}

}  // namespace vcg_core::detail
