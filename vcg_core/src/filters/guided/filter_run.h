// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coarse_rounds.h"

namespace vcg_core::detail {

/// What one run of the filter leaves, before anything is held back.
struct FilterRun {
  Array<UnitNormal> normal;  ///< by face: the filtered ones
  Array<Vec3> position;
};

/// Steps 1 to 4 of docs/guided.md.
/// @param coarse  has not run, and its noise is above 0
FilterRun run_filter(const PassInput& input, const GuidedSettings& settings, CoarseRounds& coarse);

}  // namespace vcg_core::detail
