// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <support/flat_mesh.h>

namespace test_support {

/// What SmoothingReport says of a result, counted anew with sets and in long double.
struct ResultCensus {
  std::size_t flipped_faces = 0;
  std::size_t far_moved_vertices = 0;
  std::size_t beyond_ring_vertices = 0;
};

/// @param before, after  the same faces over the stored positions
ResultCensus take_census(const FlatMesh& before, const FlatMesh& after);

}  // namespace test_support
