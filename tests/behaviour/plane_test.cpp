// SPDX-License-Identifier: GPL-3.0-or-later
// A plane has no noise: nothing on it moves, whatever its triangles.

#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/noisy_shapes.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>

namespace {

using namespace test_support;

class Plane : public testing::TestWithParam<std::tuple<std::string, SmoothingPath>> {};

TEST_P(Plane, InACoordinatePlaneStaysBitForBit) {
  const auto& [shape, path] = GetParam();
  const FlatMesh plane = noisy_shape(shape, 1000, 0);
  vcg_core::SmoothingParameters parameters = path.parameters;
  parameters.boundary = vcg_core::Boundary::free;
  parameters.iterations = 3;
  EXPECT_TRUE(same_bits(smoothed(plane, parameters), plane));
}

TEST_P(Plane, AtAnyAngleStaysUpToRounding) {
  const auto& [shape, path] = GetParam();
  const FlatMesh plane = transformed(noisy_shape(shape, 1000, 0), [](const Point& p) {
    return Point(0.6 * p[0] - 0.3 * p[1], 0.2 * p[0] + p[1], 0.4 * p[0] + 0.7 * p[1] + 2);
  });
  vcg_core::SmoothingParameters parameters = path.parameters;
  parameters.boundary = vcg_core::Boundary::free;
  const double e = average_edge_length(plane);
  EXPECT_LE(difference(smoothed(plane, parameters), plane, 0).largest, path.rounding * e);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Plane,
                         testing::Combine(testing::Values("plane_slash", "plane_backslash", "plane_alternating",
                                                          "plane_random_diagonals", "plane_delaunay"),
                                          testing::ValuesIn(smoothing_paths())),
                         [](const auto& instance) {
                           return std::get<0>(instance.param) + "_" + std::get<1>(instance.param).name;
                         });

}  // namespace
