// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "face_lists.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Mean distance of adjoining centroids around each face: 0.6 times the mean edge length at its vertices, smoothed over
/// three rings, so that neighbourhoods follow the mesh where edges become shorter or longer.
/// @param least  in units of the positions: where edges are shorter, the spacing is this, or that of the average edge
///               if that is less
Array<double> local_spacing(const MeshArrays& mesh, bool follow_edge_length, double least, Job& job);

/// For each face those with a centroid closer than radius * spacing[f] that faces of this kind connect with it by
/// faces around: a ball that does not leak to a sheet that is near in space and far on the surface. At least the faces
/// around it where that gives fewer than four.
/// @param across  as faces_across() finds them
FaceLists faces_within(const MeshArrays& mesh, const Array<Index>& across, const Array<Vec3>& position,
                       const Array<double>& spacing, double radius, Job& job);

}  // namespace vcg_core::detail
