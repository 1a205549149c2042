// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <vcg_core/smoothing_parameters.h>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Whether a vertex stays because the caller says so: by `boundary`, `selected_only` or a weight of 0.
inline bool is_held(const MeshArrays& mesh, const SmoothingParameters& parameters, std::size_t v) {
  return (parameters.boundary == Boundary::fixed && mesh.topology.border[v]) ||
         (parameters.selected_only && !mesh.is_selected(v)) || (!mesh.weight.empty() && mesh.weight[v] == 0);
}

inline bool is_isolated(const MeshArrays& mesh, std::size_t v) {
  return mesh.topology.star_begin[v] == mesh.topology.star_begin[v + 1];
}

}  // namespace vcg_core::detail
