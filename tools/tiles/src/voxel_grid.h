// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <vcg_core/mesh/guided_whole.h>

#include "large_mesh.h"
#include "plan.h"

namespace tiles {

/// The grid of the voxels whose boundary the whole mesh is, if it is one: by some cells of each tile, and then by
/// counting all vertices that are on it.
/// @param plan  its buckets are there, and |e| is known
std::optional<vcg_core::VoxelGrid> find_voxel_grid(const LargeMesh& mesh, const Plan& plan);

}  // namespace tiles
