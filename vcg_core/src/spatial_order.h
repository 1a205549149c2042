#pragma once

#include <cstdint>

#include <vcg_core/detail/mesh_arrays.h>

namespace vcg_core::detail {

struct SpatialOrder {
  Array<Index> order;         ///< old index of the vertex at each new place
  Array<std::uint64_t> code;  ///< Morton code at each new place, ascending
};

/// Orders points along a Morton curve through their bounding box: what is close in space comes close in memory.
/// Equal codes keep their given order.
SpatialOrder morton_order(const Array<Vec3>& position, Job& job);

/// Number of points that lie at exactly the place of another one.
std::size_t count_coincident(const Array<Vec3>& position, const SpatialOrder& order, Job& job);

}  // namespace vcg_core::detail
