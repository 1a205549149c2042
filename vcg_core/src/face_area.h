// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Whether a face has an area that is more than what rounding makes of none: its height is at least 1e-12 of its
/// longest edge. Below, its normal would point anywhere, and differently after each rotation of the mesh.
///
/// @param a, b   two of its edges, from the same vertex
/// @param cross  a x b
inline bool has_area(const Vec3& a, const Vec3& b, const Vec3& cross) {
  constexpr double smallest = 1e-12;
  const double longest_squared = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
  return cross.squaredNorm() > smallest * smallest * longest_squared * longest_squared;
}

}  // namespace vcg_core::detail
