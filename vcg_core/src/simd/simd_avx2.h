// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <immintrin.h>

namespace vcg_core::detail {
namespace {  // its own in every kernel: nothing compiled for one processor may be linked into another's code

/// Eight floats in one AVX2 register.
struct Simd {
  static constexpr unsigned lanes = 8;
  /// Whether this processor has these vectors.
  static bool supported() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
  using Vector = __m256;
  using Mask = __m256;

  static Vector set(float x) { return _mm256_set1_ps(x); }
  static Vector load(const float* p) { return _mm256_load_ps(p); }
  static Vector gather(const float* p, const unsigned* index) {
    return _mm256_i32gather_ps(p, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index)), 4);
  }
  static void store(float* p, Vector x) { _mm256_store_ps(p, x); }
  static Vector add(Vector a, Vector b) { return _mm256_add_ps(a, b); }
  static Vector sub(Vector a, Vector b) { return _mm256_sub_ps(a, b); }
  static Vector mul(Vector a, Vector b) { return _mm256_mul_ps(a, b); }
  static Vector div(Vector a, Vector b) { return _mm256_div_ps(a, b); }
  static Vector mul_add(Vector a, Vector b, Vector c) { return _mm256_fmadd_ps(a, b, c); }   // a b + c
  static Vector mul_sub(Vector a, Vector b, Vector c) { return _mm256_fmsub_ps(a, b, c); }   // a b - c
  static Vector sub_mul(Vector c, Vector a, Vector b) { return _mm256_fnmadd_ps(a, b, c); }  // c - a b
  static Vector min(Vector a, Vector b) { return _mm256_min_ps(a, b); }
  static Vector max(Vector a, Vector b) { return _mm256_max_ps(a, b); }
  static Vector abs(Vector a) { return _mm256_andnot_ps(set(-0.0f), a); }
  static Vector sqrt(Vector a) { return _mm256_sqrt_ps(a); }
  static Mask less(Vector a, Vector b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
  static bool any(Mask m) { return _mm256_movemask_ps(m) != 0; }
  static Vector select(Mask m, Vector yes, Vector no) { return _mm256_blendv_ps(no, yes, m); }
  static Vector min_where(Mask m, Vector a, Vector b) { return select(m, min(a, b), a); }
  static Vector zero_unless(Mask m, Vector a) { return _mm256_and_ps(m, a); }
  static float lowest(Vector a) {
    const __m128 four = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
    const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)));
  }
  static Vector round(Vector a) { return _mm256_round_ps(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }
  /// a 2^n for whole n in [-126, 127].
  static Vector scale(Vector a, Vector n) {
    const __m256i exponent = _mm256_slli_epi32(_mm256_add_epi32(_mm256_cvtps_epi32(n), _mm256_set1_epi32(127)), 23);
    return mul(a, _mm256_castsi256_ps(exponent));
  }
};

}  // namespace
}  // namespace vcg_core::detail
