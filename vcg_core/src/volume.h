// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// The smallest box around all positions; empty if there are none.
Eigen::AlignedBox3d bounding_box(const Array<Vec3>& position, Job& job);

/// The box around all vertices as they were read, those of the whole where the mesh is a piece.
Eigen::AlignedBox3d box_of_whole(const RawMesh& mesh, Job& job);

/// Signed volume between the faces that count, placed at `position`, and `apex`: for a closed surface that looks
/// outwards the enclosed volume, whatever the apex; one near the mesh keeps rounding small. In cubes of the unit of
/// `position`.
double signed_volume(const MeshArrays& mesh, const Array<Vec3>& position, const Vec3& apex, Job& job);

/// The same with the centre of the mesh's box as apex, wherever the faces are now, and in the caller's unit.
double volume_over_center(const MeshArrays& mesh, const Array<Vec3>& position, Job& job);

}  // namespace vcg_core::detail
