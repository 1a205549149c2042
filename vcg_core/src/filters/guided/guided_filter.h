// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filters/filter.h"
#include "guided_settings.h"
#include "whole_medians.h"

namespace vcg_core::detail {

/// Guided anisotropic smoothing; docs/guided.md holds the equations, their sources and what each step brings.
/// Normals of faces are filtered coarsely by guides, the vertices following, then finely by themselves; the noisy
/// vertices are moved to where the faces have these normals; and detail that was taken for noise is brought back.
Filter guided_filter();

/// Its one pass. By itself for the ablation, which changes the settings.
PassOutput guided_pass(const PassInput& input, const GuidedSettings& settings);

/// The medians over the mesh that such a pass goes by, as GuidedWhole has them. No more is done than they need.
/// @param input   of a piece that is told the noise of the whole
/// @param counts  as WholeMedians has them
std::vector<double> medians_of_guided_pass(const PassInput& input, const GuidedSettings& settings,
                                           std::vector<ValueCounts>* counts);

}  // namespace vcg_core::detail
