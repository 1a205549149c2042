// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <mesh_tools/flat_mesh.h>

namespace anisosmooth {

/// Vertices that no face or edge uses and that have no finite place: filters refuse such places, and are to pass over
/// them.
struct HiddenVertices {
  explicit HiddenVertices(const mesh_tools::FlatMesh& mesh);

  std::size_t count = 0;
  std::vector<std::uint8_t> marks;  ///< 1 for each of them; empty if there is none
};

}  // namespace anisosmooth
