// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"

namespace vcg_core::detail {

/// Bilateral mesh denoising (Fleishman, Drori, Cohen-Or 2003) as section 3 of the paper gives it: v_i moves
/// along its normal by the mean height n_i.(v_i - v_j) of the vertices in a Euclidean ball, weighted by W_c and W_s.
///
/// The ball takes in the whole mesh, not only the part that is connected to v_i: that it reaches through thin parts is
/// the flaw that the paper's filter mends. v_i itself is in it, as the printed set says.
///
/// Where the code differs: Fleishman computes normals over 1, 2 or 3 rings depending on the model; here it is the
/// angle-weighted ring that the paper's filter uses, so that a comparison shows the filters and not the normals.
/// Fleishman estimates sigma_s from the mesh; here it is a parameter, as in Table 1.
Filter bmd_filter();

}  // namespace vcg_core::detail
