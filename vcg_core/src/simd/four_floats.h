// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simd_portable.h"

namespace vcg_core::detail {
namespace {  // as in the kernels

/// Four floats that are calculated with as one number is, so that a formula written for numbers takes them too.
struct FourFloats {
  Quad value;

  FourFloats() = default;
  FourFloats(Quad four) : value(four) {}
  FourFloats(float same) : value(quad::set(same)) {}
  /// From memory that is aligned for them.
  static FourFloats at(const float* p) { return quad::load(p); }
  void store(float* p) const { quad::store(p, value); }

  FourFloats& operator+=(FourFloats b) { return *this = quad::add(value, b.value); }
  FourFloats& operator*=(FourFloats b) { return *this = quad::mul(value, b.value); }
  friend FourFloats operator+(FourFloats a, FourFloats b) { return quad::add(a.value, b.value); }
  friend FourFloats operator-(FourFloats a, FourFloats b) { return quad::sub(a.value, b.value); }
  friend FourFloats operator*(FourFloats a, FourFloats b) { return quad::mul(a.value, b.value); }
  friend FourFloats operator/(FourFloats a, FourFloats b) { return quad::div(a.value, b.value); }
  friend FourFloats max(FourFloats a, FourFloats b) { return quad::max(a.value, b.value); }
  friend FourFloats min(FourFloats a, FourFloats b) { return quad::min(a.value, b.value); }
  friend FourFloats abs(FourFloats a) { return quad::abs(a.value); }
  friend FourFloats sqrt(FourFloats a) { return quad::sqrt(a.value); }

  /// Four rows become four columns.
  friend void transpose(FourFloats& a, FourFloats& b, FourFloats& c, FourFloats& d) {
    quad::transpose(a.value, b.value, c.value, d.value);
  }
};

}  // namespace
}  // namespace vcg_core::detail
