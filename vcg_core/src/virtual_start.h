// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace vcg_core::detail {

/// A triangle in its own plane, as seen from one of its vertices, the apex v_i. The opposite edge runs along the x-axis
/// from v_{i+1} at the origin to v_{i+2} at (edge, 0); the apex lies at (x, y) with y >= 0.
template <class Scalar>
struct TriangleFrame {
  Scalar edge;  ///< |v_{i+1} v_{i+2}|
  Scalar x;
  Scalar y;
  Scalar side_1;  ///< |v_i v_{i+1}|
  Scalar side_2;  ///< |v_i v_{i+2}|
};

/// How much the squared height of the virtual start point may fall below 0 by rounding, in squared edge lengths.
constexpr double touching = 1e-12;

/// Section 4.1, figures 3 and 4: the distance of the apex, given the distances d_1 and d_2 of the two others.
///
/// The circles about v_{i+1} and v_{i+2} with radii d_1 and d_2 meet, on the far side from the apex, in the virtual
/// start point v_s = (x_s, -h_s). If the straight line from v_s to v_i passes between v_{i+1} and v_{i+2}, the distance
/// is |v_i v_s|; otherwise it goes around one of the two (figures 4a and 4b). The two ways around join the minimum in
/// every case, which also covers circles that do not meet, and triangles without area.
template <class Scalar>
Scalar distance_by_virtual_start(const TriangleFrame<Scalar>& t, Scalar d_1, Scalar d_2) {
  const Scalar around = std::min(d_1 + t.side_1, d_2 + t.side_2);
  if (!(t.edge > 0)) return around;
  const Scalar x_s = (d_1 - d_2) * (d_1 + d_2) / (2 * t.edge) + t.edge / 2;
  const Scalar h_s_squared = d_1 * d_1 - x_s * x_s;
  // Circles that touch, as about the ends of an edge with the start on it, may miss each other by rounding.
  if (!(h_s_squared >= -touching * t.edge * t.edge)) return around;
  const Scalar h_s = std::sqrt(std::max(h_s_squared, Scalar(0)));
  const Scalar height = h_s + t.y;
  if (!(height > 0)) return around;               // all on one line, which meets the edge nowhere or everywhere
  const Scalar crossing = x_s * t.y + t.x * h_s;  // where the line meets the edge, times height
  if (!(crossing >= 0 && crossing <= t.edge * height)) return around;
  return std::min(around, std::sqrt((t.x - x_s) * (t.x - x_s) + height * height));
}

}  // namespace vcg_core::detail
