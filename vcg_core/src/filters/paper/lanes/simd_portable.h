// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace vcg_core::detail {
namespace {  // as in the other kernels

/// Eight floats as two of the compiler's generic vectors: SSE2 on the baseline of x86-64, NEON on ARM, and so on. Two
/// of four, as what these processors have: GCC compares wider ones number by number.
struct Simd {
  static constexpr unsigned lanes = 8;
  typedef float Quad __attribute__((vector_size(16)));
  typedef std::int32_t Bits __attribute__((vector_size(16)));
  struct Vector {
    Quad low, high;
  };
  struct Mask {
    Bits low, high;
  };

  static Vector set(float x) { return {x - Quad{}, x - Quad{}}; }
  static Vector load(const float* p) {
    Vector x;
    __builtin_memcpy(&x, p, sizeof x);
    return x;
  }
  static Vector gather(const float* p, const std::uint32_t* index) {
    return {Quad{p[index[0]], p[index[1]], p[index[2]], p[index[3]]},
            Quad{p[index[4]], p[index[5]], p[index[6]], p[index[7]]}};
  }
  static void store(float* p, Vector x) { __builtin_memcpy(p, &x, sizeof x); }
  static Vector add(Vector a, Vector b) { return {a.low + b.low, a.high + b.high}; }
  static Vector sub(Vector a, Vector b) { return {a.low - b.low, a.high - b.high}; }
  static Vector mul(Vector a, Vector b) { return {a.low * b.low, a.high * b.high}; }
  static Vector div(Vector a, Vector b) { return {a.low / b.low, a.high / b.high}; }
  static Vector mul_add(Vector a, Vector b, Vector c) { return add(mul(a, b), c); }
  static Vector mul_sub(Vector a, Vector b, Vector c) { return sub(mul(a, b), c); }
  static Vector sub_mul(Vector c, Vector a, Vector b) { return sub(c, mul(a, b)); }
  static Vector min(Vector a, Vector b) { return {min(a.low, b.low), min(a.high, b.high)}; }
  static Vector max(Vector a, Vector b) { return {max(a.low, b.low), max(a.high, b.high)}; }
  static Vector abs(Vector a) { return {abs(a.low), abs(a.high)}; }
  static Vector sqrt(Vector a) { return {sqrt(a.low), sqrt(a.high)}; }
  static Mask less(Vector a, Vector b) { return {a.low < b.low, a.high < b.high}; }
  static Mask both(Mask a, Mask b) { return {a.low & b.low, a.high & b.high}; }
  static bool any(Mask m) {
    const Bits either = m.low | m.high;
    std::uint64_t all[2];
    __builtin_memcpy(all, &either, sizeof either);
    return (all[0] | all[1]) != 0;
  }
  static Vector select(Mask m, Vector yes, Vector no) {
    return {select(m.low, yes.low, no.low), select(m.high, yes.high, no.high)};
  }
  static Vector min_where(Mask m, Vector a, Vector b) { return select(both(m, less(b, a)), b, a); }
  static float lowest(Vector a) {
    const Quad four = min(a.low, a.high);
    const float x = four[0] < four[1] ? four[0] : four[1];
    const float y = four[2] < four[3] ? four[2] : four[3];
    return x < y ? x : y;
  }
  static Vector zero_unless(Mask m, Vector a) { return select(m, a, set(0)); }
  /// To the nearest whole number, for |a| < 2^22: adding and taking away 1.5 * 2^23 leaves no fraction.
  static Vector round(Vector a) { return sub(add(a, set(12582912.0f)), set(12582912.0f)); }
  /// a 2^n for whole n in [-126, 127].
  static Vector scale(Vector a, Vector n) { return mul(a, {power(n.low), power(n.high)}); }

 private:
  static Quad min(Quad a, Quad b) { return a < b ? a : b; }
  static Quad max(Quad a, Quad b) { return a > b ? a : b; }
  static Quad abs(Quad a) { return reinterpret_cast<Quad>(reinterpret_cast<Bits>(a) & 0x7fffffff); }
  static Quad sqrt(Quad a) {
    for (unsigned i = 0; i < 4; ++i) a[i] = __builtin_sqrtf(a[i]);
    return a;
  }
  static Quad select(Bits m, Quad yes, Quad no) {
    return reinterpret_cast<Quad>((m & reinterpret_cast<Bits>(yes)) | (~m & reinterpret_cast<Bits>(no)));
  }
  static Quad power(Quad n) { return reinterpret_cast<Quad>((__builtin_convertvector(n, Bits) + 127) << 23); }
};

}  // namespace
}  // namespace vcg_core::detail
