// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/smoothing_report.h>

#include "mesh_arrays.h"

namespace vcg_core::detail {

class Job;

/// Rounds the positions as the caller's mesh will store them, so that all figures are of what the user gets.
void round_as_stored(const MeshArrays& mesh, Array<Vec3>& position, Job& job);

/// Compares the new positions with those that were read and fills in what SmoothingReport::warnings() judges by:
/// faces, flipped_faces, the vertices that moved far, closed and coordinate_spacing.
/// @param position  one per vertex, in units of RawMesh::position
/// @throws Cancelled
void check_result(const MeshArrays& mesh, const Array<Vec3>& position, SmoothingReport& report, Job& job);

}  // namespace vcg_core::detail
