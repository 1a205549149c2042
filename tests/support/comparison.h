// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <gtest/gtest.h>

#include <support/flat_mesh.h>
#include <support/smoothing_path.h>

namespace test_support {

/// How far corresponding points of two meshes are from each other.
struct Difference {
  double largest = 0;
  std::size_t at = 0;                ///< the vertex of the largest
  std::size_t beyond_tolerance = 0;  ///< number of vertices
};

Difference difference(const FlatMesh& a, const FlatMesh& b, double tolerance);

/// Whether two results agree up to the rounding of `path`: all vertices within its tolerance times `e`, but for the
/// share whose neighbourhood it may decide otherwise.
testing::AssertionResult same_smoothing(const FlatMesh& a, const FlatMesh& b, const SmoothingPath& path, double e);

/// Whether all coordinates are finite.
bool all_finite(const FlatMesh& mesh);

/// Whether two meshes have the same points bit for bit.
bool same_bits(const FlatMesh& a, const FlatMesh& b);

}  // namespace test_support
