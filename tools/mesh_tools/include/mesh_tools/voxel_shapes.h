// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include <mesh_tools/mesh.h>

namespace mesh_tools {

/// How a solid becomes voxels.
struct VoxelGrid {
  double slice_distance = 1;  ///< distance of the slices along z, in pixels; 1: cubes
  double tilt = 0;            ///< degrees by which the solid is turned against the grid, about the axis (1, 2, 3)
};

/// The surface of a binary volume, as of a label map of computed tomography, and what it stands for.
struct VoxelShape {
  Mesh surface;      ///< vertices half-way between the centres of a voxel inside and one outside
  Mesh truth;        ///< the same faces, each vertex at the nearest point of the solid's surface
  double pixel = 0;  ///< width of a voxel in x and y, in the mesh's unit
};

/// Whether `name` begins with "voxel_"; '-' and '_' are the same.
bool is_voxel_shape(const std::string& name);

/// Fills a solid with voxels whose width gives about `vertices` vertices, and takes the boundary of those whose centres
/// are inside, by marching cubes (Lorensen and Cline 1987; vcglib's, with the topology of Lewiner et al. 2003): closed,
/// oriented outwards, a manifold with shared vertices. Within 5 % of the number from some thousands on.
/// @param name  "voxel_" before the name of a closed shape of all_shapes()
/// @throws std::invalid_argument for another name, a slice distance outside 1 to 6, a tilt that is not finite, and
/// where
///         no voxel's centre is inside, as with a plate that lies between two slices
VoxelShape make_voxel_shape(const std::string& name, std::size_t vertices, const VoxelGrid& grid = {});

}  // namespace mesh_tools
