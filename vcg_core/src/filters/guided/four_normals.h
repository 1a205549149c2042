// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "packed_normal.h"
#include "simd/four_floats.h"
#include "unit_normals.h"

namespace vcg_core::detail {
namespace {  // as in the kernels

/// Four normals, one coordinate of all in a register.
struct FourNormals {
  FourFloats x, y, z;
};

inline FourFloats squared_distances(const FourNormals& a, const FourNormals& b) {
  const FourFloats x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + (y * y + z * z);
}

/// Four that follow each other.
inline FourNormals unpacked(const PackedNormal* normals) {
  constexpr float one = PackedNormal::one;
  const auto where = [](QuadMask mask, FourFloats yes, FourFloats no) {
    return FourFloats(quad::select(mask, yes.value, no.value));
  };
  FourFloats x = quad::low_halves(PackedNormal::bits(normals));
  FourFloats y = quad::high_halves(PackedNormal::bits(normals));
  const FourFloats z = FourFloats(one) - abs(x) - abs(y);
  const FourFloats zero = 0.0F, fold = min(z, zero);
  const QuadMask is_zero = quad::less(x.value, FourFloats(-one).value);
  x = x + where(quad::less(x.value, zero.value), zero - fold, fold);
  y = y + where(quad::less(y.value, zero.value), zero - fold, fold);
  const FourFloats length = sqrt(x * x + y * y + z * z);
  return {where(is_zero, zero, x / length), where(is_zero, zero, y / length), where(is_zero, zero, z / length)};
}

/// Up to four; the last one stands for those that are missing.
/// @param count  above 0
inline FourNormals unpacked(const PackedNormal* normals, std::size_t count) {
  if (count >= 4) return unpacked(normals);
  const PackedNormal four[] = {normals[0], normals[std::min<std::size_t>(1, count - 1)], normals[count - 1],
                               normals[count - 1]};
  return unpacked(four);
}

inline void unpack(const PackedNormal* normals, std::size_t count, UnitNormal* unit) {
  for (std::size_t i = 0; i < count; i += 4) {
    const FourNormals four = unpacked(normals + i, count - i);
    FourFloats rows[] = {four.x, four.y, four.z, 0.0F};
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (std::size_t k = 0; k < std::min<std::size_t>(4, count - i); ++k) rows[k].store(unit[i + k].data());
  }
}

}  // namespace
}  // namespace vcg_core::detail
