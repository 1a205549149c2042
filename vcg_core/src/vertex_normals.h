// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Unit normal of each vertex: the mean of the normals of its faces, weighted by the angle each face has there.
/// Section 7 asks for "only the 1-ring face" and leaves the weights open; with angles the normal does not depend on
/// how the surface is cut into triangles. Zero where none is defined: no face, no area, or normals that cancel.
Array<Vec3> vertex_normals(const MeshArrays& mesh, const Array<Vec3>& position, Job& job);

}  // namespace vcg_core::detail
