// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "guided_settings.h"
#include "mesh/vertex_attributes.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Smooths colour and quality on the smoothed surface: ten times the mean over the one ring, neighbours weighted by
/// exp(-|n_i - n_j|^2 / (2 fine_range^2)) of the vertex normals, the weight of the fine rounds. Across an edge the
/// normals differ, so that nothing bleeds over; along it, and within a face of the shape, they do not. Vertices that
/// may not move keep theirs and serve as neighbours. Numbers that are not finite stay and are passed over.
///
/// Copies of a vertex that have the same numbers are smoothed as one. Others, as along the seams of charts, keep apart,
/// each smoothed by the faces on its own side.
/// @param mesh      with MeshArrays::corner_copy
/// @param position  the smoothed one
void smooth_attributes(const MeshArrays& mesh, const Array<Vec3>& position, const Array<std::uint8_t>& movable,
                       const GuidedSettings& settings, VertexAttributes& attributes, Job& job);

}  // namespace vcg_core::detail
