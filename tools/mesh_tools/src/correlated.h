// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <mesh_tools/mesh.h>

namespace mesh_tools {

/// From independent values of equal variance, one a vertex, makes such of the same variance whose correlation at
/// distance d is exp(-d^2 / length^2), on a surface with evenly spread vertices: a Gaussian sum over the vertices that
/// are joined to each by a path of edges within 2 lengths of it. In time that follows the number of such pairs.
/// @param length  above 0, in the mesh's unit
/// @param first   for each vertex the first one at its place; the values of the others do not count, and they get that
///                one's result
std::vector<vcg::Point3d> correlated(const Mesh& mesh, double length, const std::vector<std::size_t>& first,
                                     const std::vector<vcg::Point3d>& values);

}  // namespace mesh_tools
