// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh without noise comes back from the guided filter as it was.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <support/clean_shapes.h>
#include <support/hand_made.h>
#include <support/noisy_shapes.h>
#include <support/smoothed_by.h>

namespace {

using test_support::FlatMesh;
using test_support::Point;
using test_support::Triangle;

Point area_vector(const FlatMesh& mesh, const Triangle& f) {
  return (mesh.points[f[1]] - mesh.points[f[0]]) ^ (mesh.points[f[2]] - mesh.points[f[0]]);
}

std::size_t turned_faces(const FlatMesh& before, const FlatMesh& after) {
  return static_cast<std::size_t>(std::count_if(before.faces.begin(), before.faces.end(), [&](const Triangle& f) {
    return area_vector(before, f) * area_vector(after, f) < 0;
  }));
}

double rms_displacement(const FlatMesh& before, const FlatMesh& after) {
  double sum = 0;
  for (std::size_t v = 0; v < before.points.size(); ++v) sum += (after.points[v] - before.points[v]).SquaredNorm();
  return std::sqrt(sum / static_cast<double>(before.points.size()));
}

void expect_left_alone(const std::string& name, const FlatMesh& mesh) {
  const test_support::SmoothedBy result = test_support::smoothed_by(vcg_core::Method::guided, mesh);
  EXPECT_LT(rms_displacement(mesh, result.mesh), 0.02 * result.report.average_edge_length) << name;
  EXPECT_EQ(turned_faces(mesh, result.mesh), 0u) << name;
  if (result.report.border_vertices == 0) {
    EXPECT_NEAR(result.report.volume_after, result.report.volume_before, 1e-3 * std::abs(result.report.volume_before))
        << name;
  }
}

TEST(GuidedCleanMesh, OfEveryTessellationIsLeftAlone) {
  for (const test_support::CleanShape& shape : test_support::clean_shapes()) expect_left_alone(shape.name, shape.mesh);
}

TEST(GuidedCleanMesh, OfEveryGeneratedShapeIsLeftAlone) {
  for (const std::string& name : test_support::shape_names())
    expect_left_alone(name, test_support::noisy_shape(name, 3000, 0));
}

// A cube has no vertex off its edges: nothing tells noise from shape, and the report says so.
TEST(GuidedCleanMesh, IsNamedAsSuch) {
  const vcg_core::SmoothingReport report =
      test_support::smoothed_by(vcg_core::Method::guided, test_support::cube()).report;
  EXPECT_EQ(report.moved_vertices, 0u);
  EXPECT_EQ(report.estimated_noise, 0.0);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_NE(report.warnings()[0].find("no noise that can be told from its shape"), std::string::npos);
}

}  // namespace
