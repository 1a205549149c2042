// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"
#include "ring_means.h"

namespace vcg_core::detail {

/// Heights of the vertices above the mean of their one ring, along the mean normal of their faces; 0 without faces.
Array<double> ring_heights(const MeshArrays& mesh, const RingMeans& rings, const Array<Vec3>& position, Job& job);

}  // namespace vcg_core::detail
