// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "guided_settings.h"
#include "mesh_arrays.h"
#include "unit_normals.h"

namespace vcg_core::detail {

/// Moves vertices until the faces look along the filtered normals: `updates` times each movable vertex by the mean over
/// its faces of n_f (n_f . (c_f - v)), with c_f the centroid of the face as it lies now.
///
/// Source: Sun, Rosin, Martin, Langbein: Fast and effective feature-preserving mesh denoising, 2007, equation (9).
/// Vertices move along the normals of faces and not along their own: at an edge they come back onto it, elsewhere they
/// do not drift. New here: vertices of folded faces (turned away from their filtered normal), as noise in random
/// directions leaves them, are drawn to the middle of their ring within the surface as well, until the fold is open.
void update_positions(const MeshArrays& mesh, const Array<UnitNormal>& normal, const Array<std::uint8_t>& movable,
                      int updates, const GuidedSettings& settings, Array<Vec3>& position, Job& job);

}  // namespace vcg_core::detail
