#pragma once

#include <vector>

#include <vcg_core/detail/mesh_arrays.h>

#include "virtual_start.h"

namespace vcg_core::detail {

/// The frame of every face at each of its corners, by corner. Lengths are those of `position` divided by `unit`.
std::vector<TriangleFrame<double>> triangle_frames(const MeshArrays& mesh, const std::vector<Vec3>& position,
                                                   double unit, Job& job);

}  // namespace vcg_core::detail
