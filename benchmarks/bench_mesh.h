// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <job.h>
#include <mesh_arrays.h>
#include <mesh_tools/mesh.h>

namespace bench {

/// How the vertices of a benchmark's mesh are ordered before the library sees them.
enum class Order { as_made, shuffled };

/// What a benchmark works on: a generated shape with noise along its normals, as the command line makes it.
struct Kind {
  std::size_t vertices = 35000;
  Order order = Order::as_made;
  std::string shape = "cad_part";
  double noise = 0.2;  ///< in |e|

  bool operator<(const Kind& other) const;
};

/// Made once and kept.
const mesh_tools::Mesh& noisy_mesh(const Kind& kind);

/// The same as the algorithms see it.
struct Arrays {
  vcg_core::detail::MeshArrays mesh;
  vcg_core::detail::Array<vcg_core::detail::Vec3> normal;
  vcg_core::detail::Array<std::uint8_t> movable;
};
const Arrays& noisy_arrays(const Kind& kind);

/// Number of pairs (source, vertex nearer than rho), with every movable vertex a source; rho in |e|.
std::size_t count_pairs(const Arrays& arrays, double rho);

/// A job of one thread, without progress.
vcg_core::detail::Job single_thread();

}  // namespace bench
