// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <support/flat_mesh.h>

namespace test_support {

/// What SmoothingReport says of a mesh before anything is smoothed, counted anew with maps and in long double.
/// Vertices at the same place are one vertex and count each.
struct MeshCensus {
  std::size_t isolated = 0;
  std::size_t border = 0;
  std::size_t non_manifold = 0;
  std::size_t coincident = 0;
  std::size_t degenerate_faces = 0;
};

MeshCensus take_census(const FlatMesh& mesh);

}  // namespace test_support
