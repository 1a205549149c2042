// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"

namespace vcg_core::detail {

/// Table 1's lambda and mu.
constexpr float taubin_lambda = 0.6307f;
constexpr float taubin_mu = -0.6732f;

/// Taubin's signal processing: vcglib's tri::Smooth::VertexCoordTaubin, a lambda step and a mu step a pass. Each moves
/// a vertex by lambda (or mu) times its distance from the mean of its neighbours, towards it.
///
/// Where the code differs: vcglib averages border vertices with their neighbours along the border and with themselves.
/// The second is undone here: along a border that is free the rule is the one above.
Filter taubin_filter();

}  // namespace vcg_core::detail
