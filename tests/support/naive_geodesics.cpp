// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/naive_geodesics.h>

#include <algorithm>
#include <cmath>

namespace test_support {

namespace {

/// A unit vector at right angles to the unit vector u, on the side of `towards`; any, if `towards` is along u up to
/// rounding.
Point perpendicular(const Point& u, const Point& towards) {
  Point w = towards - u * (u * towards);
  if (w.Norm() <= 1e-12 * towards.Norm()) {
    const int smallest = std::abs(u[0]) < std::abs(u[1]) ? (std::abs(u[0]) < std::abs(u[2]) ? 0 : 2)
                                                         : (std::abs(u[1]) < std::abs(u[2]) ? 1 : 2);
    Point axis(0, 0, 0);
    axis[smallest] = 1;
    w = axis - u * (u * axis);
  }
  return w / w.Norm();
}

}  // namespace

double naive_virtual_start(const Point& apex, const Point& v_1, double d_1, const Point& v_2, double d_2) {
  const double around_1 = d_1 + (apex - v_1).Norm();
  const double around_2 = d_2 + (apex - v_2).Norm();
  const double e = (v_2 - v_1).Norm();
  if (e == 0) return std::min(around_1, around_2);
  const Point along = (v_2 - v_1) / e;
  const Point up = perpendicular(along, apex - v_1);

  // The circles |v_s - v_1| = d_1 and |v_s - v_2| = d_2.
  const double foot = (d_1 * d_1 - d_2 * d_2 + e * e) / (2 * e);
  const double depth_squared = d_1 * d_1 - foot * foot;
  if (depth_squared < -1e-12 * e * e) return std::min(around_1, around_2);  // they do not meet
  const double depth = std::sqrt(std::max(depth_squared, 0.0));
  const Point v_s = v_1 + along * foot - up * depth;

  // Where the line from v_s to the apex meets the line through v_1 and v_2.
  const double height = (apex - v_1) * up;
  if (depth + height == 0) return std::min(around_1, around_2);  // all on one line
  const Point meeting = v_s + (apex - v_s) * (depth / (depth + height));
  const double place = (meeting - v_1) * along;
  if (place < 0) return around_1;  // figure 4a
  if (place > e) return around_2;  // figure 4b
  return (apex - v_s).Norm();      // figure 3
}

std::vector<double> naive_geodesics(const FlatMesh& split, std::size_t source, double gain, double reach) {
  const FlatMesh mesh = welded(split);
  const std::vector<std::size_t> first = first_in_place(split);
  std::vector<double> distance(mesh.points.size(), std::numeric_limits<double>::infinity());
  distance[first[source]] = 0;
  bool improved = true;
  while (improved) {
    improved = false;
    const auto offer = [&](std::size_t v, double d) {
      if (!(d < distance[v] - gain)) return;
      distance[v] = d;
      improved = true;
    };
    for (const Triangle& f : mesh.faces) {
      if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
      for (int k = 0; k < 3; ++k) {
        const std::size_t apex = f[k];
        const std::size_t a = f[(k + 1) % 3];
        const std::size_t b = f[(k + 2) % 3];
        const Point* p = mesh.points.data();
        const bool a_known = std::isfinite(distance[a]) && distance[a] <= reach;
        const bool b_known = std::isfinite(distance[b]) && distance[b] <= reach;
        if (a_known) offer(apex, distance[a] + (p[apex] - p[a]).Norm());
        if (b_known) offer(apex, distance[b] + (p[apex] - p[b]).Norm());
        if (a_known && b_known) offer(apex, naive_virtual_start(p[apex], p[a], distance[a], p[b], distance[b]));
      }
    }
  }
  for (std::size_t v = 0; v < distance.size(); ++v) distance[v] = distance[first[v]];
  return distance;
}

}  // namespace test_support
