// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// A unit normal, or zero, in single precision: what is averaged many times over. The fourth number is 0, so that a
/// vector register takes a normal at once.
using UnitNormal = Eigen::Vector4f;

inline UnitNormal in_single(const Vec3& n) {
  return {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2]), 0};
}

inline Vec3 in_double(const UnitNormal& n) { return {n[0], n[1], n[2]}; }

}  // namespace vcg_core::detail
