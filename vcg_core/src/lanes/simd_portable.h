#pragma once

#include <cstdint>

namespace vcg_core::detail {
namespace {  // as in the other kernels

/// Eight floats as the compiler's generic vectors: SSE2 on the baseline of x86-64, NEON on ARM, and so on.
struct Simd {
  static constexpr unsigned lanes = 8;
  typedef float Vector __attribute__((vector_size(32)));
  typedef std::int32_t Mask __attribute__((vector_size(32)));

  static Vector set(float x) { return x - Vector{}; }
  static Vector load(const float* p) {
    Vector x;
    __builtin_memcpy(&x, p, sizeof x);
    return x;
  }
  static Vector gather(const float* p, const std::uint32_t* index) {
    Vector x;
    for (unsigned i = 0; i < lanes; ++i) x[i] = p[index[i]];
    return x;
  }
  static void store(float* p, Vector x) { __builtin_memcpy(p, &x, sizeof x); }
  static Vector add(Vector a, Vector b) { return a + b; }
  static Vector sub(Vector a, Vector b) { return a - b; }
  static Vector mul(Vector a, Vector b) { return a * b; }
  static Vector div(Vector a, Vector b) { return a / b; }
  static Vector mul_add(Vector a, Vector b, Vector c) { return a * b + c; }
  static Vector mul_sub(Vector a, Vector b, Vector c) { return a * b - c; }
  static Vector sub_mul(Vector c, Vector a, Vector b) { return c - a * b; }
  static Vector min(Vector a, Vector b) { return select(a < b, a, b); }
  static Vector max(Vector a, Vector b) { return select(a > b, a, b); }
  static Vector abs(Vector a) { return reinterpret_cast<Vector>(reinterpret_cast<Mask>(a) & 0x7fffffff); }
  static Vector sqrt(Vector a) {
    for (unsigned i = 0; i < lanes; ++i) a[i] = __builtin_sqrtf(a[i]);
    return a;
  }
  static Mask less(Vector a, Vector b) { return a < b; }
  static Mask both(Mask a, Mask b) { return a & b; }
  static bool any(Mask m) {
    std::int32_t all = 0;
    for (unsigned i = 0; i < lanes; ++i) all |= m[i];
    return all != 0;
  }
  static Vector select(Mask m, Vector yes, Vector no) {
    return reinterpret_cast<Vector>((m & reinterpret_cast<Mask>(yes)) | (~m & reinterpret_cast<Mask>(no)));
  }
  static Vector min_where(Mask m, Vector a, Vector b) { return select(both(m, b < a), b, a); }
  static Vector zero_unless(Mask m, Vector a) { return reinterpret_cast<Vector>(m & reinterpret_cast<Mask>(a)); }
  /// To the nearest whole number, for |a| < 2^22: adding and taking away 1.5 * 2^23 leaves no fraction.
  static Vector round(Vector a) { return (a + 12582912.0f) - 12582912.0f; }
  /// a 2^n for whole n in [-126, 127].
  static Vector scale(Vector a, Vector n) {
    const Mask exponent = (__builtin_convertvector(n, Mask) + 127) << 23;
    return a * reinterpret_cast<Vector>(exponent);
  }
};

}  // namespace
}  // namespace vcg_core::detail
