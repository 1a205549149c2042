#pragma once

#include "filter.h"

namespace vcg_core::detail {

/// "Improved Laplacian" smoothing (Vollmer, Mencl, Mueller 1999): vcglib's tri::Smooth::VertexCoordLaplacianHC, a step
/// a pass, with the constants that it has built in: beta = 0.5 and alpha = 0, as it looks back to the previous step
/// only. These are Table 1's.
///
/// vcglib differs from the article. With b_j the way from v_j to the mean of its neighbours, the article moves v_i by
/// b_i - (beta b_i + (1 - beta) mean b_j); vcglib adds the second mean where the article subtracts it, so its step is
/// (1 - beta) (b_i + mean b_j): nothing is pushed back, and it shrinks about as Laplacian smoothing does.
FilterPass make_hc_pass();

}  // namespace vcg_core::detail
