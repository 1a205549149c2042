// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "patch.h"

namespace vcg_core::detail {

/// The ball around the middle of a group of sources that holds them all, in |e| and relative to the patch's middle.
struct GroupBall {
  float middle[3];
  float radius;
};

/// Orders the rows of a patch for one group of its sources after the other. One a thread; its memory is reused.
class GroupOrder {
 public:
  explicit GroupOrder(LaneNear within_reach) : within_reach_(within_reach) {}

  /// @param source_row  the patch's rows of the group's sources; kept by reference
  /// @param reach       distance from a source, in |e|, up to which rows are wanted
  const PatchGroup& of(const Patch& patch, const std::uint32_t* source_row, std::uint32_t sources,
                       const GroupBall& ball, float reach);

 private:
  void select_near_rows(const Patch& patch, const GroupBall& ball, float reach);
  void sort_by_radius(std::uint32_t patch_rows);

  LaneNear within_reach_;
  PatchGroup group_{};
  std::vector<std::uint32_t> near_;
  std::vector<float> squared_radius_of_near_;
  std::vector<std::uint32_t> bucket_begin_;
  std::vector<std::uint32_t> row_at_;
  std::vector<std::uint32_t> rank_of_;
  std::vector<float> squared_radius_;
  std::vector<std::uint64_t> dirty_;
  std::vector<std::uint32_t> queue_;
};

}  // namespace vcg_core::detail
