// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lane_spread.h"
#include "lane_sweep.h"

namespace vcg_core::detail {
namespace {

/// Both ways end at the same fixed point. Which one is taken depends on the patch and the group only.
MarchWork lane_march(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, LanePoll poll,
                     void* context) {
  // Larger balls take in what the surface's bends bring near. Measured on the shapes of the benchmarks: from 6,000 to
  // 12,000 rows on the sweep loses.
  constexpr std::uint32_t most_rows_to_sweep = 8192;
  std::uint64_t looks = 0;
  if (!patch.has_hubs && group.rows <= most_rows_to_sweep) {
    Sweep sweep(patch, group, parameters, poll, context);
    if (sweep.run()) return {sweep.looks(), false};
    looks = sweep.looks();
  }
  Spread spread(patch, group, parameters, poll, context);
  spread.run();
  return {looks + spread.looks(), spread.loosened()};
}

}  // namespace
}  // namespace vcg_core::detail
