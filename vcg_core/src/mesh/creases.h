// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Finds the edges between the given pairs of vertices and fills in MeshTopology's creases.
/// @param pairs  in the order of the arrays, any of them more than once
void find_creases(MeshArrays& mesh, Array<std::array<Index, 2>> pairs, Job& job);

/// Adds the faces around v that a walk around v reaches from one of its faces without crossing a crease, that face
/// among them, to the end of `found`.
/// @param corner  of that face at v
void add_faces_of_sector(const MeshArrays& mesh, Index v, Index corner, Array<Index>& found);

}  // namespace vcg_core::detail
