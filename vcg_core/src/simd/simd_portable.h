// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include "quad_sse2.h"
#else
#include "quad_vector.h"
#endif

namespace vcg_core::detail {
namespace {  // as in the other kernels

/// Eight floats as two vectors of four, which every processor of today has. Products and sums are rounded one by one,
/// so that all processors give the same bits.
struct Simd {
  static constexpr unsigned lanes = 8;
  /// Whether this processor has these vectors.
  static bool supported() { return true; }
  struct Vector {
    Quad low, high;
  };
  struct Mask {
    QuadMask low, high;
  };

  static Vector set(float x) { return {quad::set(x), quad::set(x)}; }
  // Each half by itself: GCC takes pairs around by the stack.
  static Vector load(const float* p) { return {quad::load(p), quad::load(p + 4)}; }
  static Vector gather(const float* p, const std::uint32_t* index) {
    return {quad::set(p[index[0]], p[index[1]], p[index[2]], p[index[3]]),
            quad::set(p[index[4]], p[index[5]], p[index[6]], p[index[7]])};
  }
  static void store(float* p, Vector x) {
    quad::store(p, x.low);
    quad::store(p + 4, x.high);
  }
  static Vector add(Vector a, Vector b) { return {quad::add(a.low, b.low), quad::add(a.high, b.high)}; }
  static Vector sub(Vector a, Vector b) { return {quad::sub(a.low, b.low), quad::sub(a.high, b.high)}; }
  static Vector mul(Vector a, Vector b) { return {quad::mul(a.low, b.low), quad::mul(a.high, b.high)}; }
  static Vector div(Vector a, Vector b) { return {quad::div(a.low, b.low), quad::div(a.high, b.high)}; }
  static Vector mul_add(Vector a, Vector b, Vector c) { return add(mul(a, b), c); }
  static Vector mul_sub(Vector a, Vector b, Vector c) { return sub(mul(a, b), c); }
  static Vector sub_mul(Vector c, Vector a, Vector b) { return sub(c, mul(a, b)); }
  static Vector min(Vector a, Vector b) { return {quad::min(a.low, b.low), quad::min(a.high, b.high)}; }
  static Vector max(Vector a, Vector b) { return {quad::max(a.low, b.low), quad::max(a.high, b.high)}; }
  static Vector abs(Vector a) { return {quad::abs(a.low), quad::abs(a.high)}; }
  static Vector sqrt(Vector a) { return {quad::sqrt(a.low), quad::sqrt(a.high)}; }
  static Mask less(Vector a, Vector b) { return {quad::less(a.low, b.low), quad::less(a.high, b.high)}; }
  static Mask both(Mask a, Mask b) { return {quad::both(a.low, b.low), quad::both(a.high, b.high)}; }
  static bool any(Mask m) { return quad::any_of(m.low, m.high); }
  static Vector select(Mask m, Vector yes, Vector no) {
    return {quad::select(m.low, yes.low, no.low), quad::select(m.high, yes.high, no.high)};
  }
  static Vector min_where(Mask m, Vector a, Vector b) { return select(both(m, less(b, a)), b, a); }
  static float lowest(Vector a) { return quad::lowest(quad::min(a.low, a.high)); }
  static Vector zero_unless(Mask m, Vector a) { return select(m, a, set(0)); }
  /// To the nearest whole number, for |a| < 2^22: adding and taking away 1.5 * 2^23 leaves no fraction.
  static Vector round(Vector a) { return sub(add(a, set(12582912.0f)), set(12582912.0f)); }
  /// a 2^n for whole n in [-126, 127].
  static Vector scale(Vector a, Vector n) { return mul(a, {quad::power_of_two(n.low), quad::power_of_two(n.high)}); }
};

}  // namespace
}  // namespace vcg_core::detail
