#pragma once

#include <vector>

#include <vcg_core/detail/mesh_arrays.h>

#include "virtual_start.h"

namespace vcg_core::detail {

/// The frame of every face at each of its corners, by corner. Lengths are those of `position` divided by `unit`.
template <class Scalar>
std::vector<TriangleFrame<Scalar>> triangle_frames(const MeshArrays& mesh, const std::vector<Vec3>& position,
                                                   Scalar unit, Job& job);

}  // namespace vcg_core::detail
