// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <emmintrin.h>

namespace vcg_core::detail {
namespace {  // as in the other kernels

/// Four floats in a register of SSE2, which every x86-64 processor has.
using Quad = __m128;
using QuadMask = __m128;

namespace quad {

inline Quad set(float a, float b, float c, float d) { return _mm_setr_ps(a, b, c, d); }
inline Quad set(float x) { return _mm_set1_ps(x); }
inline Quad load(const float* p) { return _mm_load_ps(p); }
inline void store(float* p, Quad x) { _mm_store_ps(p, x); }
/// The low, and the high 16 bits of four whole numbers, as numbers with a sign.
inline Quad low_halves(const std::int32_t* p) {
  const __m128i all = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
  return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_slli_epi32(all, 16), 16));
}
inline Quad high_halves(const std::int32_t* p) {
  return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)), 16));
}
inline Quad add(Quad a, Quad b) { return _mm_add_ps(a, b); }
inline Quad sub(Quad a, Quad b) { return _mm_sub_ps(a, b); }
inline Quad mul(Quad a, Quad b) { return _mm_mul_ps(a, b); }
inline Quad div(Quad a, Quad b) { return _mm_div_ps(a, b); }
inline Quad min(Quad a, Quad b) { return _mm_min_ps(a, b); }
inline Quad max(Quad a, Quad b) { return _mm_max_ps(a, b); }
inline Quad abs(Quad a) { return _mm_andnot_ps(set(-0.0f), a); }
inline Quad sqrt(Quad a) { return _mm_sqrt_ps(a); }
inline QuadMask less(Quad a, Quad b) { return _mm_cmplt_ps(a, b); }
inline QuadMask both(QuadMask a, QuadMask b) { return _mm_and_ps(a, b); }
inline bool any_of(QuadMask a, QuadMask b) { return _mm_movemask_ps(_mm_or_ps(a, b)) != 0; }
inline Quad select(QuadMask m, Quad yes, Quad no) { return _mm_or_ps(_mm_and_ps(m, yes), _mm_andnot_ps(m, no)); }
inline float lowest(Quad a) {
  const Quad two = _mm_min_ps(a, _mm_movehl_ps(a, a));
  return _mm_cvtss_f32(_mm_min_ss(two, _mm_shuffle_ps(two, two, 1)));
}
/// Four rows become four columns.
inline void transpose(Quad& a, Quad& b, Quad& c, Quad& d) { _MM_TRANSPOSE4_PS(a, b, c, d); }
/// 2^n for whole n in [-126, 127].
inline Quad power_of_two(Quad n) {
  return _mm_castsi128_ps(_mm_slli_epi32(_mm_add_epi32(_mm_cvtps_epi32(n), _mm_set1_epi32(127)), 23));
}

}  // namespace quad
}  // namespace
}  // namespace vcg_core::detail
