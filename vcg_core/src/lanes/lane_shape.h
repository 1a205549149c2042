#pragma once

#include "lane_vector3.h"

namespace vcg_core::detail {
namespace {

/// Shapes of the `lanes` faces from `first` on.
void shape_faces(const Patch& patch, std::uint32_t first) {
  const Vector3 v_1 = gather_places(patch, patch.row_1 + first);
  const Vector3 v_2 = gather_places(patch, patch.row_2 + first);
  const Vector3 apex = gather_places(patch, patch.apex + first);
  const Vector3 along = difference(v_2, v_1);
  const Vector3 to_apex = difference(apex, v_1);
  const Vector squared_edge = dot(along, along);
  const Vector edge = Simd::sqrt(squared_edge);
  const Vector half_edge = Simd::mul(edge, Simd::set(0.5f));
  const Vector zero = Simd::set(0);
  const Vector one = Simd::set(1);
  const Mask has_edge = Simd::less(Simd::set(1e-14f), edge);
  const Vector inverse = Simd::zero_unless(has_edge, Simd::div(one, Simd::max(edge, Simd::set(1e-14f))));
  const Vector3 normal = cross(along, to_apex);
  const Vector3 from_2 = difference(apex, v_2);
  const Vector columns[] = {
      Simd::select(has_edge, half_edge, Simd::sub(zero, one)),
      Simd::mul(inverse, Simd::set(0.5f)),
      squared_edge,
      Simd::mul_sub(dot(to_apex, along), inverse, half_edge),
      Simd::select(has_edge, Simd::mul(Simd::sqrt(dot(normal, normal)), inverse), one),
      Simd::sqrt(dot(to_apex, to_apex)),
      Simd::sqrt(dot(from_2, from_2)),
      Simd::zero_unless(has_edge, edge),
  };
  alignas(64) float column[8][Simd::lanes];
  for (int k = 0; k < 8; ++k) Simd::store(column[k], columns[k]);
  for (unsigned lane = 0; lane < Simd::lanes; ++lane)
    patch.shape[first + lane] = {column[0][lane], column[1][lane], column[2][lane], column[3][lane],
                                 column[4][lane], column[5][lane], column[6][lane], column[7][lane]};
}

void lane_shape(const Patch& patch, LanePoll poll, void* context) {
  // Rounded up to whole vectors: the builder leaves room behind the last face.
  for (std::uint32_t f = 0; f < patch.face_begin[patch.rows]; f += Simd::lanes) {
    if (f % 65536 == 0) poll(context);
    shape_faces(patch, f);
  }
}

}  // namespace
}  // namespace vcg_core::detail
