// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Multiplies by 2^exponent. In two steps, as the power itself may not be a finite number.
class PowerOfTwo {
 public:
  explicit PowerOfTwo(int exponent)
      : half_(std::ldexp(1.0, exponent / 2)), rest_(std::ldexp(1.0, exponent - exponent / 2)) {}
  double operator*(double x) const { return x * half_ * rest_; }
  Vec3 operator*(const Vec3& x) const { return Vec3(*this * x[0], *this * x[1], *this * x[2]); }

 private:
  double half_;
  double rest_;
};

}  // namespace vcg_core::detail
