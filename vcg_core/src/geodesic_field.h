// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Distances from one vertex of the caller's mesh to all of its vertices, in its unit; see geodesic_distances.
std::vector<double> geodesic_field(const MeshArrays& mesh, std::size_t host_source, Job& job);

}  // namespace vcg_core::detail
