// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

namespace vcg_core::detail {

/// A unit normal, or zero, in 4 bytes: its place on an octahedron that is unfolded into a square, to within 7e-5. A
/// dozen candidates a face are most of what the guided filter holds. four_normals.h packs and unpacks them.
///
/// Source: Meyer, Süßmuth, Sußner, Stamminger, Greiner: On floating-point normal vectors, 2010.
class PackedNormal {
 public:
  PackedNormal() = default;
  /// From places in the square, from -one to one, or both `none`.
  static PackedNormal at(float x, float y) {
    PackedNormal normal;
    normal.bits_ = combined(rounded(x), rounded(y));
    return normal;
  }

  /// What stands for x and y, from -one to one: y in the high 16 bits. A number with many divisors, so that normals
  /// along the axes and half-way between them are exact, and do not lie where rounding goes either way.
  static constexpr int one = 32760;
  /// Both of the zero vector.
  static constexpr int none = -one - 1;
  static const std::int32_t* bits(const PackedNormal* normals) { return &normals->bits_; }

 private:
  /// To the nearest number, halves away from zero.
  static int rounded(float x) { return static_cast<int>(x + std::copysign(0.5F, x)); }
  static constexpr std::int32_t combined(int x, int y) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(y) << 16 | (static_cast<std::uint32_t>(x) & 0xffff));
  }

  std::int32_t bits_ = combined(none, none);
};

}  // namespace vcg_core::detail
