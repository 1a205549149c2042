// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// What a piece of a larger mesh is told of the whole; null: the mesh is no such piece, and measures it itself.
inline const GuidedWhole* told_whole(const MeshArrays& mesh) {
  return mesh.whole && mesh.whole->guided ? &*mesh.whole->guided : nullptr;
}

}  // namespace vcg_core::detail
