// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lane_vector3.h"

namespace vcg_core::detail {
namespace {

/// 2^-x for x >= 0, within 2e-7 of its value; what underflows gives about 1e-38.
Vector exp2_of_minus(Vector x) {
  const Vector y = Simd::sub(Simd::set(0), Simd::min(x, Simd::set(126)));
  const Vector whole = Simd::round(y);
  const Vector f = Simd::sub(y, whole);  // in [-1/2, 1/2]
  // Taylor's polynomial of 2^f: the coefficients are ln(2)^k / k!.
  Vector power = Simd::set(1.5403530e-4f);
  power = Simd::mul_add(power, f, Simd::set(1.3333558e-3f));
  power = Simd::mul_add(power, f, Simd::set(9.6181291e-3f));
  power = Simd::mul_add(power, f, Simd::set(5.5504109e-2f));
  power = Simd::mul_add(power, f, Simd::set(2.4022651e-1f));
  power = Simd::mul_add(power, f, Simd::set(6.9314718e-1f));
  power = Simd::mul_add(power, f, Simd::set(1.0f));
  return Simd::scale(power, whole);
}

/// Section 6's sums for all lanes: rows are the neighbours v_j, lanes the vertices v_i.
void lane_offsets(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, float* offset) {
  alignas(64) float place[3][Simd::lanes] = {};
  alignas(64) float normal[3][Simd::lanes] = {};
  for (std::uint32_t lane = 0; lane < group.sources; ++lane)
    for (int axis = 0; axis < 3; ++axis) {
      place[axis][lane] = patch.place[axis][group.source_row[lane]];
      normal[axis][lane] = patch.normal[axis][group.source_row[lane]];
    }
  const Vector3 v_i{Simd::load(place[0]), Simd::load(place[1]), Simd::load(place[2])};
  const Vector3 n_i{Simd::load(normal[0]), Simd::load(normal[1]), Simd::load(normal[2])};
  const Vector cutoff = Simd::set(parameters.cutoff);
  const Vector closeness = Simd::set(parameters.closeness);
  const Vector similarity = Simd::set(parameters.similarity);
  const Vector normals = Simd::set(parameters.normals);
  Vector sum = Simd::set(0);
  Vector sum_of_weights = Simd::set(0);
  for (std::uint32_t rank = 0; rank < group.rows; ++rank) {
    const std::uint32_t row = group.row_at[rank];
    const Mask inside = Simd::less(Simd::load(patch.distance + std::size_t(row) * Simd::lanes), cutoff);
    if (!Simd::any(inside)) continue;
    if (patch.normal[0][row] == 0 && patch.normal[1][row] == 0 && patch.normal[2][row] == 0) continue;
    const Vector3 v_j = at_row(patch.place, row);
    const Vector3 n_j = at_row(patch.normal, row);
    const Vector3 from_j = difference(v_i, v_j);
    const Vector height = dot(n_j, from_j);
    const Vector s = Simd::mul(height, similarity);
    const Vector n = Simd::mul(Simd::sub(Simd::set(1), dot(n_i, n_j)), normals);
    const Vector exponent = Simd::mul_add(dot(from_j, from_j), closeness, Simd::mul_add(s, s, Simd::mul(n, n)));
    const Vector weight = Simd::zero_unless(inside, exp2_of_minus(exponent));
    sum = Simd::mul_add(weight, height, sum);
    sum_of_weights = Simd::add(sum_of_weights, weight);
  }
  alignas(64) float result[Simd::lanes];
  Simd::store(result, Simd::div(sum, Simd::max(sum_of_weights, Simd::set(1e-30f))));
  for (std::uint32_t lane = 0; lane < group.sources; ++lane) offset[lane] = result[lane];
}

}  // namespace
}  // namespace vcg_core::detail
