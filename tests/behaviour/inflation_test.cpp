// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's filter moves convex surfaces outwards: by how much stands in docs/comparison.md, and here.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <support/hand_made.h>
#include <support/smoothed_by.h>

namespace {

using namespace test_support;
using vcg_core::Method;

/// A cylinder of radius 1 and height 1: its side cut into long triangles, its lids into fans from the middle.
FlatMesh cylinder(std::size_t sides) {
  FlatMesh mesh;
  for (const double z : {0.0, 1.0})
    for (std::size_t i = 0; i < sides; ++i) {
      const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(sides);
      mesh.points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  mesh.points.emplace_back(0, 0, 0);
  mesh.points.emplace_back(0, 0, 1);
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = (i + 1) % sides;
    mesh.faces.insert(
        mesh.faces.end(),
        {{i, j, sides + j}, {i, sides + j, sides + i}, {2 * sides, j, i}, {2 * sides + 1, sides + i, sides + j}});
  }
  return mesh;
}

void expect_gain(const FlatMesh& mesh, double percent) {
  const vcg_core::SmoothingReport report = smoothed_by(Method::paper, mesh).report;
  EXPECT_NEAR(100 * (report.volume_after / report.volume_before - 1), percent, 0.1);
  EXPECT_EQ(report.warnings().empty(), percent < 5);
}

TEST(Inflation, OfCoarseConvexShapesByThePapersFilter) {
  expect_gain(cube(), 37.7);
  expect_gain(cylinder(32), 97.2);
  const double sphere[] = {70.0, 44.5, 16.8, 4.6, 1.2};
  for (int levels = 1; levels <= 5; ++levels) {
    SCOPED_TRACE(levels);
    expect_gain(icosphere(levels), sphere[levels - 1]);
  }
}

}  // namespace
