// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <vcg_core/filters/paper_parameters.h>

#include "filters/filter.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Neighbourhoods are marched this far, in |e|, beyond the cut-off: an edge with one end beyond it still feeds vertices
/// inside.
constexpr double march_margin = 0.5;

/// One pass of the paper's filter: section 6's offset d_i along n_i over the geodesic neighbourhood of section 4.
///
/// @param position  where the vertices are, in units of MeshArrays::position
/// @param normal    their normals; zero where undefined: such a vertex neither moves nor counts as a neighbour
/// @param movable   whether each vertex may move
/// @return          the new positions
Array<Vec3> paper_pass(const MeshArrays& mesh, const Array<Vec3>& position, const Array<Vec3>& normal,
                       const Array<std::uint8_t>& movable, const PaperParameters& parameters, Job& job);

/// With the fast path of lanes/ or, by PaperParameters::arithmetic, with paper_pass.
Filter paper_filter();

}  // namespace vcg_core::detail
