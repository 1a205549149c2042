// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// A list of faces for each face, itself first.
struct FaceLists {
  Array<std::size_t> begin;  ///< one more than faces
  Array<Index> face;

  const Index* first(std::size_t f) const { return face.data() + begin[f]; }
  const Index* last(std::size_t f) const { return face.data() + begin[f + 1]; }
};

constexpr Index no_face = static_cast<Index>(-1);

/// The face across each edge, by corner: the edge opposite to the corner. `no_face` at borders, at edges with three
/// or more faces and at creases.
Array<Index> faces_across(const MeshArrays& mesh, Job& job);

/// For each face all faces that share a vertex with it and lie on the same side of the creases there; at vertices with
/// very many faces only those across an edge, so that the lists stay linear in the mesh.
FaceLists faces_around(const MeshArrays& mesh, const Array<Index>& across, Job& job);

/// Mean distance of adjoining centroids around each face: 0.6 times the mean edge length at its vertices, smoothed over
/// three rings, so that neighbourhoods follow the mesh where edges become shorter or longer.
/// @param least  in units of the positions: where edges are shorter, the spacing is this, or that of the average edge
///               if that is less
Array<double> local_spacing(const MeshArrays& mesh, bool follow_edge_length, double least, Job& job);

/// For each face those with a centroid closer than radius * spacing[f] that faces of this kind connect with it: a ball
/// that does not leak to a sheet that is near in space and far on the surface. At least the faces around it where that
/// gives fewer than four.
FaceLists faces_within(const FaceLists& around, const Array<Vec3>& centroid, const Array<double>& spacing,
                       double radius, Job& job);

}  // namespace vcg_core::detail
