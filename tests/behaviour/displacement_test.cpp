// SPDX-License-Identifier: GPL-3.0-or-later
// No vertex drifts: in one pass each moves along its normal.

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>

namespace {

using namespace test_support;

class Displacement : public testing::TestWithParam<std::tuple<std::string, SmoothingPath>> {};

TEST_P(Displacement, IsParallelToTheVertexNormal) {
  const auto& [shape, path] = GetParam();
  const FlatMesh mesh = noisy_shape(shape, 600);
  vcg_core::SmoothingParameters parameters = path.parameters;
  parameters.boundary = vcg_core::Boundary::free;
  const FlatMesh result = smoothed(mesh, parameters);
  const NaiveReference reference(mesh);
  const double e = reference.average_edge_length();
  double longest = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Point move = result.points[v] - mesh.points[v];
    longest = std::max(longest, move.Norm());
    EXPECT_LE((move ^ reference.normal(v)).Norm(), path.rounding * e) << v;
  }
  EXPECT_GT(longest, 0.01 * e);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Displacement,
    testing::Combine(testing::Values("sphere", "cube", "plane_delaunay", "graded_cube", "thin_sheets"),
                     testing::ValuesIn(smoothing_paths())),
    [](const auto& instance) { return std::get<0>(instance.param) + "_" + std::get<1>(instance.param).name; });

}  // namespace
