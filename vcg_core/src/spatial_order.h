// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <Eigen/Geometry>

#include "mesh_arrays.h"

namespace vcg_core::detail {

struct SpatialOrder {
  Array<Index> order;         ///< old index of the vertex at each new place
  Array<std::uint64_t> code;  ///< Morton code at each new place, ascending
};

/// Orders points along a Morton curve through their bounding box: what is close in space comes close in memory.
/// Points of equal code come in the order of their coordinates, so that points at the same place are next to each other
/// and nothing depends on how many there are; those keep their given order.
SpatialOrder morton_order(const Array<Vec3>& position, Job& job);

/// The same along the curve through a box that holds all points: points that are in two sets come in the same order in
/// both, where the box is the same.
SpatialOrder morton_order(const Array<Vec3>& position, const Eigen::AlignedBox3d& box, Job& job);

}  // namespace vcg_core::detail
