#pragma once

#include <vcg_core/detail/mesh_arrays.h>

namespace vcg_core::detail {

/// Signed volume between the faces, placed at `position`, and `apex`: for a closed surface that looks outwards the
/// enclosed volume, whatever the apex. In cubes of the unit of `position`.
double signed_volume(const MeshArrays& mesh, const Array<Vec3>& position, const Vec3& apex);

/// Centre of the bounding box: the apex that keeps rounding small, and the same one before and after smoothing.
Vec3 box_center(const Array<Vec3>& position);

}  // namespace vcg_core::detail
