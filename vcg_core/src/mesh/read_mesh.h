// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/mesh/mesh_view.h>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Copies a caller's mesh into arrays, as one stage of the job.
/// @param options  weld_distance in the caller's unit
/// @throws InvalidMesh: no faces, too many vertices or faces, a coordinate that is not finite (with count and first
///         index), a face that refers to no vertex of the mesh, no edge of any length; InvalidParameter: a weight
///         outside [0, 1]
MeshArrays read_mesh(const MeshView& view, Job& job, ReadOptions options = {});

}  // namespace vcg_core::detail
