// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vcg_core/progress.h>

namespace vcg_core {

/// The same for any vcglib triangle mesh; deleted elements are passed over, no adjacency is needed.
/// @param source  index into mesh.vert of a vertex that is not deleted
/// @return        one distance per element of mesh.vert
template <class Mesh, class = typename Mesh::VertexType>
std::vector<double> geodesic_distances(const Mesh& mesh, std::size_t source, const Progress& progress = {}) {
  return geodesic_distances(view_of(mesh), source, progress);
}

}  // namespace vcg_core
