// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// A face and its plane.
struct PlacedFace {
  std::array<Index, 3> vertex;
  std::array<Vec3, 3> corner;
  Vec3 normal = Vec3::Zero();  ///< of length 1; zero where the face has no area
  double tilt = 0;             ///< 1 / its height over its longest edge: how far an error of a corner tilts the plane
};

PlacedFace place_face(const std::array<Index, 3>& vertex, const Array<Vec3>& position);

/// Whether each of two faces reaches to both sides of the other's plane, and the pieces that they have of the line
/// where the planes meet overlap. After Moeller, "A fast triangle-triangle intersection test", 1997, but nothing counts
/// that an error of `rounding` in the coordinates could make.
bool faces_cross(const PlacedFace& a, const PlacedFace& b, double rounding);

}  // namespace vcg_core::detail
