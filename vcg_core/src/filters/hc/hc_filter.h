// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"

namespace vcg_core::detail {

/// Table 1's alpha and beta.
constexpr double hc_alpha = 0;
constexpr double hc_beta = 0.5;

/// Improved Laplacian smoothing, the HC algorithm: Vollmer, Mencl, Mueller, "Improved Laplacian Smoothing of Noisy
/// Surface Meshes", 1999; a step a pass. With o_i the original places, q_i those before the step and adj(i) the
/// neighbours of vertex i:
///
///     p_i := mean of q_j over adj(i)                         the Laplacian step
///     b_i := p_i - (alpha o_i + (1 - alpha) q_i)             how far it went
///     p_i := p_i - (beta b_i + (1 - beta) mean of b_j)       pushed back by the mean of that
///
/// Vertices that may not move have b_j = 0, as they went nowhere.
///
/// Where the code differs: the article is silent about borders; here the neighbours of a border vertex are those along
/// the border, as for Laplacian and Taubin's smoothing, so that a free border is not drawn inwards.
Filter hc_filter();

}  // namespace vcg_core::detail
