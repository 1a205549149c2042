// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#if !defined(__GNUC__) && !defined(__clang__)
#error "for this compiler and processor no vectors of four floats are known: they need a file beside quad_sse2.h"
#endif
#ifdef __ARM_NEON
#include <arm_neon.h>
#endif

namespace vcg_core::detail {
namespace {  // as in the other kernels

/// Four floats as the generic vector of GCC and Clang: NEON on ARM, and so on. No longer one, as these processors have
/// no longer ones: GCC compares those number by number.
typedef float Quad __attribute__((vector_size(16)));
typedef std::int32_t QuadMask __attribute__((vector_size(16)));

namespace quad {

inline Quad set(float a, float b, float c, float d) { return Quad{a, b, c, d}; }
inline Quad set(float x) { return x - Quad{}; }
inline Quad load(const float* p) {
  Quad x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}
inline void store(float* p, Quad x) { __builtin_memcpy(p, &x, sizeof x); }
/// The low, and the high 16 bits of four whole numbers, as numbers with a sign.
inline Quad low_halves(const std::int32_t* p) {
  QuadMask all;
  __builtin_memcpy(&all, p, sizeof all);
  return __builtin_convertvector((all << 16) >> 16, Quad);
}
inline Quad high_halves(const std::int32_t* p) {
  QuadMask all;
  __builtin_memcpy(&all, p, sizeof all);
  return __builtin_convertvector(all >> 16, Quad);
}
inline Quad add(Quad a, Quad b) { return a + b; }
inline Quad sub(Quad a, Quad b) { return a - b; }
inline Quad mul(Quad a, Quad b) { return a * b; }
inline Quad div(Quad a, Quad b) { return a / b; }
#ifdef __ARM_NEON  // one instruction, where compilers make two of the comparison
inline Quad min(Quad a, Quad b) { return vminnmq_f32(a, b); }
inline Quad max(Quad a, Quad b) { return vmaxnmq_f32(a, b); }
#else
inline Quad min(Quad a, Quad b) { return a < b ? a : b; }
inline Quad max(Quad a, Quad b) { return a > b ? a : b; }
#endif
inline Quad abs(Quad a) { return reinterpret_cast<Quad>(reinterpret_cast<QuadMask>(a) & 0x7fffffff); }
inline Quad sqrt(Quad a) {
  for (unsigned i = 0; i < 4; ++i) a[i] = __builtin_sqrtf(a[i]);
  return a;
}
inline QuadMask less(Quad a, Quad b) { return a < b; }
inline QuadMask both(QuadMask a, QuadMask b) { return a & b; }
inline bool any_of(QuadMask a, QuadMask b) {
  const QuadMask either = a | b;
  std::uint64_t all[2];
  __builtin_memcpy(all, &either, sizeof either);
  return (all[0] | all[1]) != 0;
}
inline Quad select(QuadMask m, Quad yes, Quad no) {
  return reinterpret_cast<Quad>((m & reinterpret_cast<QuadMask>(yes)) | (~m & reinterpret_cast<QuadMask>(no)));
}
inline float lowest(Quad a) {
  const float x = a[0] < a[1] ? a[0] : a[1];
  const float y = a[2] < a[3] ? a[2] : a[3];
  return x < y ? x : y;
}
/// Four rows become four columns.
inline void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
  const Quad x{a[0], b[0], c[0], d[0]}, y{a[1], b[1], c[1], d[1]};
  const Quad z{a[2], b[2], c[2], d[2]}, w{a[3], b[3], c[3], d[3]};
  a = x, b = y, c = z, d = w;
}
/// 2^n for whole n in [-126, 127].
inline Quad power_of_two(Quad n) { return reinterpret_cast<Quad>((__builtin_convertvector(n, QuadMask) + 127) << 23); }

}  // namespace quad
}  // namespace
}  // namespace vcg_core::detail
