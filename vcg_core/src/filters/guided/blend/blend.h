// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../unit_normals.h"
#include "candidates.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// The normals that the learned blend finds, in two stages. Frees the coarse positions and faces. Its weights are those
/// of white_noise_weights.cpp and correlated_noise_weights.cpp, which scripts/train makes.
Array<UnitNormal> blended_normals(CoarseResult& coarse, Job& job);

}  // namespace vcg_core::detail
