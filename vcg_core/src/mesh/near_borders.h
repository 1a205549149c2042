// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Border vertices that lie next to one another without being connected.
struct NearBorders {
  std::size_t vertices = 0;  ///< copies of those that have another one so near
  double distance = 0;       ///< the largest between two of them, in units of the positions
};

/// Looks for tears that are narrower than any detail of the surface, as rounding leaves them where faces have vertices
/// of their own: pairs within 1e-5 of the diagonal of the mesh's box, and a tenth of
/// the shortest edge of one of them.
NearBorders find_near_borders(const MeshArrays& mesh, Job& job);

}  // namespace vcg_core::detail
