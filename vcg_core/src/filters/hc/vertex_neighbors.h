// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// The neighbours of vertex v: vertex[begin[v]] to vertex[begin[v + 1] - 1], ascending.
struct VertexNeighbors {
  Array<std::size_t> begin;  ///< n + 1 offsets into vertex; triangles that share nothing need more than 32 bits
  Array<Index> vertex;
};

/// The vertices that share an edge with each vertex, each once; of a border vertex only those along the border. Faces
/// with a repeated vertex are left out.
VertexNeighbors vertex_neighbors(const MeshArrays& mesh, Job& job);

}  // namespace vcg_core::detail
