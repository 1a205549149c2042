// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "patch.h"

namespace vcg_core::detail {
namespace {

using Vector = Simd::Vector;
using Mask = Simd::Mask;

struct Vector3 {
  Vector x, y, z;
};

Vector3 difference(const Vector3& a, const Vector3& b) {
  return {Simd::sub(a.x, b.x), Simd::sub(a.y, b.y), Simd::sub(a.z, b.z)};
}

Vector dot(const Vector3& a, const Vector3& b) {
  return Simd::mul_add(a.x, b.x, Simd::mul_add(a.y, b.y, Simd::mul(a.z, b.z)));
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {Simd::mul_sub(a.y, b.z, Simd::mul(a.z, b.y)), Simd::mul_sub(a.z, b.x, Simd::mul(a.x, b.z)),
          Simd::mul_sub(a.x, b.y, Simd::mul(a.y, b.x))};
}

Vector3 gather_places(const Patch& patch, const std::uint32_t* row) {
  return {Simd::gather(patch.place[0], row), Simd::gather(patch.place[1], row), Simd::gather(patch.place[2], row)};
}

/// One row's vector in all lanes.
Vector3 at_row(const float* const columns[3], std::uint32_t row) {
  return {Simd::set(columns[0][row]), Simd::set(columns[1][row]), Simd::set(columns[2][row])};
}

}  // namespace
}  // namespace vcg_core::detail
