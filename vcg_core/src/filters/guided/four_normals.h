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

inline FourFloats where(QuadMask mask, FourFloats yes, FourFloats no) {
  return quad::select(mask, yes.value, no.value);
}

inline QuadMask less(FourFloats a, FourFloats b) { return quad::less(a.value, b.value); }

/// Gives a number the sign of another.
inline FourFloats with_sign(FourFloats positive, FourFloats of) {
  return where(less(of, 0.0F), FourFloats(0.0F) - positive, positive);
}

/// Four that follow each other.
inline FourNormals unpacked(const PackedNormal* normals) {
  constexpr float one = PackedNormal::one;
  FourFloats x = quad::low_halves(PackedNormal::bits(normals));
  FourFloats y = quad::high_halves(PackedNormal::bits(normals));
  const FourFloats z = FourFloats(one) - abs(x) - abs(y);
  const FourFloats zero = 0.0F;
  const FourFloats fold = zero - min(z, zero);
  const QuadMask is_zero = less(x, -one);
  x = x - with_sign(fold, x);
  y = y - with_sign(fold, y);
  const FourFloats scale = where(is_zero, zero, FourFloats(1.0F) / sqrt(x * x + y * y + z * z));
  return {x * scale, y * scale, z * scale};
}

/// Any of them may be zero.
inline void pack(const FourNormals& normal, PackedNormal (&packed)[4]) {
  const FourFloats sum = abs(normal.x) + abs(normal.y) + abs(normal.z);
  FourFloats x = normal.x / sum, y = normal.y / sum;
  const QuadMask below = less(normal.z, 0.0F);
  const FourFloats folded = where(below, with_sign(FourFloats(1.0F) - abs(y), x), x);
  y = where(below, with_sign(FourFloats(1.0F) - abs(x), y), y);
  const QuadMask is_not_zero = less(0.0F, sum);
  constexpr float one = PackedNormal::one;
  alignas(sizeof(Quad)) float places[2][4];
  where(is_not_zero, folded * FourFloats(one), PackedNormal::none).store(places[0]);
  where(is_not_zero, y * FourFloats(one), PackedNormal::none).store(places[1]);
  for (int k = 0; k < 4; ++k) packed[k] = PackedNormal::at(places[0][k], places[1][k]);
}

inline PackedNormal packed(const UnitNormal& n) {
  PackedNormal four[4];
  pack({n[0], n[1], n[2]}, four);
  return four[0];
}

/// Up to four; the last one stands for those that are missing.
/// @param count  above 0
inline FourNormals unpacked(const PackedNormal* normals, std::size_t count) {
  if (count >= 4) return unpacked(normals);
  const PackedNormal four[] = {normals[0], normals[std::min<std::size_t>(1, count - 1)], normals[count - 1],
                               normals[count - 1]};
  return unpacked(four);
}

inline void store(const FourNormals& normals, UnitNormal (&unit)[4]) {
  FourFloats rows[] = {normals.x, normals.y, normals.z, 0.0F};
  transpose(rows[0], rows[1], rows[2], rows[3]);
  for (int k = 0; k < 4; ++k) rows[k].store(unit[k].data());
}

inline void unpack(const PackedNormal* normals, std::size_t count, UnitNormal* unit) {
  for (std::size_t i = 0; i < count; i += 4) {
    UnitNormal four[4];
    store(unpacked(normals + i, count - i), four);
    std::copy_n(four, std::min<std::size_t>(4, count - i), unit + i);
  }
}

}  // namespace
}  // namespace vcg_core::detail
