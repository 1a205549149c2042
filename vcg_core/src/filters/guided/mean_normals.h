// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"
#include "unit_normals.h"

namespace vcg_core::detail {

/// Directions of the sums of the normals of each vertex's faces; zero where they cancel.
Array<Vec3> mean_normals(const MeshArrays& mesh, const Array<UnitNormal>& face_normal, Job& job);

}  // namespace vcg_core::detail
