// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"

namespace vcg_core::detail {

/// vcglib's tri::Smooth::VertexCoordLaplacianHC, a step a pass, with the constants that it has built in: beta = 0.5 and
/// alpha = 0, as it looks back to the previous step only.
///
/// vcglib differs from the article (hc_filter.h). With b_i the displacement from v_i to the mean of its neighbours, the
/// article moves v_i by b_i - (beta b_i + (1 - beta) mean b_j); vcglib adds the second mean where the article subtracts
/// it, so its step is (1 - beta) (b_i + mean b_j): nothing is pushed back, and it shrinks about as much as Laplacian
/// smoothing does. It averages border vertices with all their neighbours, and takes b_j of fixed vertices as if they
/// moved.
Filter hc_vcglib_filter();

}  // namespace vcg_core::detail
