// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "guided_settings.h"
#include "mesh_arrays.h"
#include "whole_medians.h"

namespace vcg_core::detail {

/// Brings back the detail that filtering took for noise. What was removed, measured along the normals of the result,
/// should be white noise; where its low-passed part carries more energy than low-passed white noise of the same
/// standard deviation would, it holds shape, and that part of the low-passed residual is added again, as Wiener's
/// filter would weigh it. On planes and along straight edges nothing comes back; scans keep their skin. Twice: for a
/// low-pass of three rings, then of one.
///
/// New here; in the line of Wiener filtering and of the method noise of Buades, Coll, Morel 2005.
/// @param noisy     the positions before filtering
/// @param medians   its next one is that of what the residual has above its one ring
/// @param position  the filtered ones; changed
void recover_detail(const MeshArrays& mesh, const Array<Vec3>& noisy, const Array<std::uint8_t>& movable,
                    const GuidedSettings& settings, WholeMedians& medians, Array<Vec3>& position, Job& job);

}  // namespace vcg_core::detail
