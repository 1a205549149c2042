// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Vertex stars, edges and borders. Throws InvalidMesh if no edge has a length.
MeshTopology find_topology(const RawMesh& mesh, Job& job);

}  // namespace vcg_core::detail
