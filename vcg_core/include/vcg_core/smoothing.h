// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/mesh/smoothing.h>
#include <vcg_core/mesh/vcglib_view.h>

namespace vcg_core {

/// Smooths a vcglib mesh in place: moves vertices, changes nothing else but colour and quality on request (normals,
/// bounding box and attributes are the caller's).
///
/// @param mesh  any vcglib triangle mesh, float or double, with or without optional components; deleted elements are
///              passed over, no adjacency is needed, the selection is read and never changed
/// @return, @throws  as the function of the same name for a MeshView; of that one weights can be given
template <class Mesh, class = typename Mesh::VertexType>
SmoothingReport smooth(Mesh& mesh, Method method, const SmoothingParameters& parameters = {},
                       const Progress& progress = {}, const SmoothingLimits& limits = {}) {
  return smooth(view_of(mesh), method, parameters, progress, limits);
}

}  // namespace vcg_core
