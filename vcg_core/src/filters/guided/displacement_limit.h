// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "mesh_arrays.h"
#include "unit_normals.h"

namespace vcg_core::detail {

/// How far each vertex may move, in units of the positions: `deviations` standard deviations of the noise around it,
/// and no farther than its longest edge.
Array<double> displacement_limits(const MeshArrays& mesh, const Array<double>& noise, double deviations, Job& job);

/// Takes a position back to within `limit` of `from`; whether it had to.
bool limit_displacement(const Vec3& from, double limit, Vec3& position);

/// Shortens displacements from `from` to `position` that exceed their limits; marks their vertices in `bounded`.
void limit_displacements(const Array<Vec3>& from, const Array<double>& limit, Array<Vec3>& position,
                         Array<std::uint8_t>& bounded, Job& job);

/// Takes vertices back, half their displacement at a time and in the end all of it, until no face is turned over, but
/// for those that noise may have turned over before: their normal at `from` opposes the filtered one, and their least
/// altitude is within the limit of a vertex. Marks the vertices in `bounded`.
/// @param normal  the filtered normals of the faces
void keep_faces_upright(const MeshArrays& mesh, const Array<Vec3>& from, const Array<UnitNormal>& normal,
                        const Array<double>& limit, Array<Vec3>& position, Array<std::uint8_t>& bounded, Job& job);

}  // namespace vcg_core::detail
