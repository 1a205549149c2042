// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <immintrin.h>

namespace vcg_core::detail {
namespace {  // its own in every kernel: nothing compiled for one processor may be linked into another's code

/// Sixteen floats in one AVX-512 register.
struct Simd {
  static constexpr unsigned lanes = 16;
  /// Whether this processor has these vectors.
  static bool supported() {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  }
  using Vector = __m512;
  using Mask = __mmask16;

  static Vector set(float x) { return _mm512_set1_ps(x); }
  static Vector load(const float* p) { return _mm512_load_ps(p); }
  static Vector gather(const float* p, const unsigned* index) {
    return _mm512_i32gather_ps(_mm512_loadu_si512(index), p, 4);
  }
  static void store(float* p, Vector x) { _mm512_store_ps(p, x); }
  static Vector add(Vector a, Vector b) { return _mm512_add_ps(a, b); }
  static Vector sub(Vector a, Vector b) { return _mm512_sub_ps(a, b); }
  static Vector mul(Vector a, Vector b) { return _mm512_mul_ps(a, b); }
  static Vector div(Vector a, Vector b) { return _mm512_div_ps(a, b); }
  static Vector mul_add(Vector a, Vector b, Vector c) { return _mm512_fmadd_ps(a, b, c); }   // a b + c
  static Vector mul_sub(Vector a, Vector b, Vector c) { return _mm512_fmsub_ps(a, b, c); }   // a b - c
  static Vector sub_mul(Vector c, Vector a, Vector b) { return _mm512_fnmadd_ps(a, b, c); }  // c - a b
  static Vector min(Vector a, Vector b) { return _mm512_min_ps(a, b); }
  static Vector max(Vector a, Vector b) { return _mm512_max_ps(a, b); }
  static Vector abs(Vector a) { return _mm512_abs_ps(a); }
  static Vector sqrt(Vector a) { return _mm512_sqrt_ps(a); }
  static Mask less(Vector a, Vector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
  static bool any(Mask m) { return m != 0; }
  static Vector select(Mask m, Vector yes, Vector no) { return _mm512_mask_blend_ps(m, no, yes); }
  static Vector min_where(Mask m, Vector a, Vector b) { return _mm512_mask_min_ps(a, m, a, b); }
  static Vector zero_unless(Mask m, Vector a) { return _mm512_maskz_mov_ps(m, a); }
  static float lowest(Vector a) { return _mm512_reduce_min_ps(a); }
  static Vector round(Vector a) { return _mm512_roundscale_ps(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }
  /// a 2^n for whole n.
  static Vector scale(Vector a, Vector n) { return _mm512_scalef_ps(a, n); }
};

}  // namespace
}  // namespace vcg_core::detail
