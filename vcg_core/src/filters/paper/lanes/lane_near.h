// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lane_vector3.h"

namespace vcg_core::detail {
namespace {

std::uint32_t lane_near(const Patch& patch, const PatchGroup& group, float reach, std::uint32_t count,
                        std::uint32_t* rows, float* squared_radius) {
  alignas(64) float place[3][Simd::lanes];
  for (std::uint32_t lane = 0; lane < Simd::lanes; ++lane)
    for (int axis = 0; axis < 3; ++axis)
      place[axis][lane] = patch.place[axis][group.source_row[lane < group.sources ? lane : 0]];
  const Vector3 source{Simd::load(place[0]), Simd::load(place[1]), Simd::load(place[2])};
  const Vector squared_reach = Simd::set(reach * reach);
  std::uint32_t kept = 0;  // without branches: which rows are near is unpredictable
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t row = rows[i];
    const float squared = squared_radius[i];
    const Vector3 away = difference(source, at_row(patch.place, row));
    rows[kept] = row;
    squared_radius[kept] = squared;
    kept += Simd::any(Simd::less(dot(away, away), squared_reach)) ? 1 : 0;
  }
  return kept;
}

}  // namespace
}  // namespace vcg_core::detail
