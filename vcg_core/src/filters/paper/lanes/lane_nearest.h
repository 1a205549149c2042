// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lane_shape.h"

namespace vcg_core::detail {
namespace {

/// Stands for infinity: finite, so that no arithmetic with it gives a NaN.
constexpr float unreached = 1e15f;

/// A gain of one or two units in a distance's last place is rounding: it is not passed on, however coarse single
/// precision is out there.
constexpr float rounding = 2 * 1.1920929e-7f;

/// Section 4.1 for a face in all lanes, as in virtual_start.h but with the frame's origin in the middle of the edge.
/// Holds the smallest distance around a vertex and the smallest squared distance from a virtual start point.
struct Nearest {
  Vector around = Simd::set(unreached);
  Vector squared = Simd::set(unreached * unreached);

  void look_at(Vector d_1, Vector d_2, const ShapeVectors& shape) {
    const Vector sum = Simd::add(d_1, d_2);
    const Vector difference = Simd::sub(d_1, d_2);
    const Vector x_s = Simd::mul(Simd::mul(sum, difference), shape.half_inverse);
    // h_s = sqrt((e^2 - t^2) (s^2 - e^2)) / (2 e): factored, as d_1^2 - x_s^2 loses all digits in single precision.
    const Vector product = Simd::mul(Simd::sub_mul(shape.squared_edge, difference, difference),
                                     Simd::mul_sub(sum, sum, shape.squared_edge));
    const Vector h_s = Simd::mul(Simd::sqrt(Simd::max(product, Simd::set(0))), shape.half_inverse);
    const Vector height = Simd::add(h_s, shape.y);
    const Vector crossing = Simd::mul_add(x_s, shape.y, Simd::mul(shape.x, h_s));
    // Strictly: where all lies on one line, both sides are 0. Through an end of the edge, the way around it is the
    // same.
    const Mask between = Simd::less(Simd::abs(crossing), Simd::mul(shape.half_edge, height));
    const Vector dx = Simd::sub(shape.x, x_s);
    squared = Simd::min_where(between, squared, Simd::mul_add(dx, dx, Simd::mul(height, height)));
    around = Simd::min(around, Simd::min(Simd::add(d_1, shape.side_1), Simd::add(d_2, shape.side_2)));
  }

  Vector distance() const { return Simd::min(around, Simd::sqrt(squared)); }
};

}  // namespace
}  // namespace vcg_core::detail
