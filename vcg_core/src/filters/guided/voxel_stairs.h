// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mesh_arrays.h"
#include "ring_means.h"

namespace vcg_core::detail {

/// The grid of a binary volume, such as a label map of computed tomography, whose boundary a mesh is. Marching cubes
/// put each vertex half-way between the centres of a voxel inside and its neighbour outside, so that curved and slanted
/// surfaces are stairs; the true surface passes anywhere between the two centres.
struct VoxelStairs {
  std::array<Vec3, 3> axis;    ///< of the grid: orthogonal unit vectors, nearest to x, y and z
  std::array<double, 3> step;  ///< distance of the centres along each axis, in units of the positions
  Array<std::uint8_t> pair;    ///< by vertex: the axis along which its two voxels lie; 3 if it is not of the grid
};

/// The grid, if the mesh is such a boundary, as it came from marching cubes: moved, turned or scaled, but not smoothed.
/// What tells: normals of few directions, two of the axes among them unless these are x, y and z; coordinates along
/// each axis that are multiples of half a step; and all but one in 200 vertices are at a centre along two axes and
/// half-way along the third. Clean models of exact coordinates, as grids and blocks of steps, fail in the last.
/// Independent of the mesh's noise, for there is none. New here. In a piece of a larger mesh the grid is what is told
/// of the whole.
std::optional<VoxelStairs> find_voxel_stairs(const MeshArrays& mesh, Job& job);

/// What a grid is looked for in first: some of the mesh's vertices and of its faces' normals.
struct GridSample {
  std::vector<Vec3> position, normal;
};

/// Which levels of a grid a vertex is on: bit k tells whether it is an odd one along axis k.
unsigned parity_at(const Vec3& position, const VoxelGrid& grid);
/// It is not on levels.
constexpr unsigned off_grid = 8;

/// How many vertices of the whole mesh have each parity_at().
using ParityCounts = std::array<std::size_t, 9>;
using CountParities = std::function<ParityCounts(const VoxelGrid& grid)>;

/// The grid of a mesh, by a sample of it.
std::optional<VoxelGrid> find_voxel_grid(const GridSample& sample, double edge_length, const CountParities& count);

/// By vertex: standard deviation of its distance from the true surface, along that surface's normal n. For one between
/// voxels along axis k it is uniform within |n_k| step_k / 2 to both sides. Its normal is taken from the faces as far
/// around as the widest stairs are. 0 for vertices that are not of the grid.
Array<double> deviations_by_stairs(const MeshArrays& mesh, const RingMeans& rings, const VoxelStairs& stairs, Job& job);

}  // namespace vcg_core::detail
