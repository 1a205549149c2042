// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"

namespace vcg_core::detail {

/// Laplacian smoothing: vcglib's tri::Smooth::VertexCoordLaplacian with uniform weights, a step a pass. A vertex with
/// k neighbours goes to (v_i + 2 sum v_j) / (2 k + 1): vcglib meets each edge once in each of its two faces, and adds
/// the vertex itself once.
///
/// Where the code differs: vcglib averages border vertices with their neighbours along the border, and twice with
/// themselves. The second is undone here: along a border that is free the rule is the one above.
Filter laplacian_filter();

}  // namespace vcg_core::detail
