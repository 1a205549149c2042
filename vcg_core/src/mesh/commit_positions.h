// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/mesh/mesh_view.h>
#include <vcg_core/smoothing_report.h>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Writes the new positions into the caller's mesh and counts what moved. Nothing here can fail: the step is all or
/// nothing. A coordinate that the mesh's own type could not hold stays as it was.
/// @param mesh      as read_mesh() made it of `view`
/// @param position  one per vertex of `mesh`; a copy that lies elsewhere, as weld_distance allows, moves by the same
void commit_positions(const MeshArrays& mesh, const Array<Vec3>& position, const MeshView& view,
                      SmoothingReport& report);

}  // namespace vcg_core::detail
