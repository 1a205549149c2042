// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/smoothing_limits.h>

#include "filters/filter.h"

namespace vcg_core::detail {

/// Lets the vertices follow a pass only as far as their weights and max_displacement allow, and marks those that
/// max_displacement stopped.
/// @param before  the positions before the pass
void hold_back(const MeshArrays& mesh, const Array<Vec3>& before, const SmoothingLimits& limits, PassOutput& output,
               Job& job);

}  // namespace vcg_core::detail
