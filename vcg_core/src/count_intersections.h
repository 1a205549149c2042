// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh_arrays.h"

namespace vcg_core::detail {

class Job;

/// Number of faces, placed at `position`, that cut through another face. Throws Cancelled.
std::size_t count_self_intersections(const MeshArrays& mesh, const Array<Vec3>& position, Job& job);

}  // namespace vcg_core::detail
