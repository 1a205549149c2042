// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Which points are one vertex.
struct Welding {
  Array<Index> vertex;  ///< of each place of the order; numbered by their first points
  std::size_t vertices = 0;
};

/// Joins points at exactly the same place, and those that a chain of steps of at most `distance` joins.
/// @param order  of the points, as morton_order() gives it
/// @throws InvalidParameter: there are so many points within `distance` of each other that joining them would leave
///         nothing of the surface
Welding weld(const Array<Vec3>& position, const Array<Index>& order, double distance, Job& job);

/// Puts the vertices of a mesh into the given order and makes one of those that are welded. The first of a vertex's
/// copies gives it its place; it is selected if one of them is, and has the smallest of their weights.
/// @return  the old index of each copy, in the order of RawMesh::host_vertex
Array<Index> reorder_vertices(RawMesh& mesh, const Array<Index>& order, const Welding& welding, Job& job);

}  // namespace vcg_core::detail
