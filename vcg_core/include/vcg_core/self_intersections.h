// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vcg_core/progress.h>

namespace vcg_core {

/// The same for any vcglib triangle mesh; deleted elements are passed over, no adjacency is needed.
template <class Mesh, class = typename Mesh::VertexType>
std::size_t count_self_intersections(const Mesh& mesh, const Progress& progress = {}, int threads = 0) {
  return count_self_intersections(view_of(mesh), progress, threads);
}

}  // namespace vcg_core
