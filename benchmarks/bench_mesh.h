#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <mesh_tools/mesh.h>
#include <vcg_core/detail/job.h>
#include <vcg_core/detail/mesh_arrays.h>

namespace bench {

/// How the vertices of a benchmark's mesh are ordered before the library sees them.
enum class Order { as_made, shuffled };

/// A generated machine part with noise of 0.2 |e|, as the command line makes it; made once and kept.
const mesh_tools::Mesh& noisy_part(std::size_t vertices, Order order = Order::as_made);

/// The same as the algorithms see it.
struct Arrays {
  vcg_core::detail::MeshArrays mesh;
  std::vector<vcg_core::detail::Vec3> normal;
  std::vector<std::uint8_t> movable;
};
const Arrays& noisy_part_arrays(std::size_t vertices);

/// Number of pairs (source, vertex nearer than rho), with every vertex a source; rho in |e|.
std::size_t count_pairs(const Arrays& arrays, double rho);

/// A job of one thread, without progress.
vcg_core::detail::Job single_thread();

}  // namespace bench
