// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lane_vector3.h"

namespace vcg_core::detail {
namespace {

/// FaceShape of a face, or of as many faces as there are lanes.
struct ShapeVectors {
  Vector half_edge, half_inverse, squared_edge, x, y, side_1, side_2, edge;
};

ShapeVectors in_all_lanes(const FaceShape& shape) {
  return {
      Simd::set(shape.half_edge), Simd::set(shape.half_inverse), Simd::set(shape.squared_edge), Simd::set(shape.x),
      Simd::set(shape.y),         Simd::set(shape.side_1),       Simd::set(shape.side_2),       Simd::set(shape.edge)};
}

ShapeVectors shape_of(const Vector3& v_1, const Vector3& v_2, const Vector3& apex) {
  // In |e|. Shorter is no edge: what is left of it in single precision tells no direction, and its inverse no length.
  const Vector shortest = Simd::set(1e-14f);
  const Vector3 along = difference(v_2, v_1);
  const Vector3 to_apex = difference(apex, v_1);
  const Vector squared_edge = dot(along, along);
  const Vector edge = Simd::sqrt(squared_edge);
  const Vector half_edge = Simd::mul(edge, Simd::set(0.5f));
  const Vector zero = Simd::set(0);
  const Vector one = Simd::set(1);
  const Mask has_edge = Simd::less(shortest, edge);
  const Vector inverse = Simd::zero_unless(has_edge, Simd::div(one, Simd::max(edge, shortest)));
  const Vector3 normal = cross(along, to_apex);
  const Vector3 from_2 = difference(apex, v_2);
  return {Simd::select(has_edge, half_edge, Simd::sub(zero, one)),
          Simd::mul(inverse, Simd::set(0.5f)),
          squared_edge,
          Simd::mul_sub(dot(to_apex, along), inverse, half_edge),
          Simd::select(has_edge, Simd::mul(Simd::sqrt(dot(normal, normal)), inverse), one),
          Simd::sqrt(dot(to_apex, to_apex)),
          Simd::sqrt(dot(from_2, from_2)),
          Simd::zero_unless(has_edge, edge)};
}

/// Shapes of the `lanes` faces from `first` on.
void shape_faces(const Patch& patch, std::uint32_t first) {
  const ShapeVectors shape =
      shape_of(gather_places(patch, patch.row_1 + first), gather_places(patch, patch.row_2 + first),
               gather_places(patch, patch.apex + first));
  const Vector columns[] = {shape.half_edge, shape.half_inverse, shape.squared_edge, shape.x,
                            shape.y,         shape.side_1,       shape.side_2,       shape.edge};
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
