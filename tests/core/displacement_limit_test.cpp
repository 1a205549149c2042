// SPDX-License-Identifier: GPL-3.0-or-later
// The limits of the guided filter: how far a vertex may move, and that no face is turned over.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <job.h>
#include <support/arrays_of.h>
#include <support/hand_made.h>

#include "filters/guided/displacement_limit.h"
#include "filters/guided/face_geometry.h"

namespace {

using namespace vcg_core::detail;

const vcg_core::Progress no_progress;

class DisplacementLimit : public testing::Test {
 protected:
  DisplacementLimit() { faces.measure(mesh, mesh.position, job); }

  /// Every vertex moved at random within a ball of that radius.
  Array<Vec3> shaken(double radius) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-radius, radius);
    Array<Vec3> position = mesh.position;
    for (Vec3& p : position) p += Vec3(uniform(random), uniform(random), uniform(random));
    return position;
  }

  std::size_t turned(const Array<Vec3>& position) {
    FaceGeometry now;
    now.measure(mesh, position, job);
    std::size_t count = 0;
    for (std::size_t f = 0; f < mesh.face.size(); ++f) count += now.normal[f].dot(faces.normal[f]) < 0;
    return count;
  }

  Job job{no_progress, 2};
  MeshArrays mesh = test_support::arrays_of(test_support::icosphere(3), job);
  double e = mesh.topology.average_edge_length;
  FaceGeometry faces;
  Array<std::uint8_t> bounded = Array<std::uint8_t>(mesh.size(), 0);
};

TEST_F(DisplacementLimit, FollowsTheNoiseUpToTheLongestEdge) {
  Array<double> noise(mesh.size(), 0.01 * e);
  noise[0] = 0;
  noise[1] = 100 * e;
  const Array<double> limit = displacement_limits(mesh, noise, 5, job);
  EXPECT_EQ(limit[0], 0);
  EXPECT_DOUBLE_EQ(limit[2], 0.05 * e);
  double longest = 0;
  for (const auto& f : mesh.face)
    for (int k = 0; k < 3; ++k)
      if (f[k] == 1)
        for (const Index w : f) longest = std::max(longest, (mesh.position[w] - mesh.position[1]).norm());
  EXPECT_LT(limit[1], longest);
  EXPECT_GT(limit[1], 0.99 * longest);
}

TEST_F(DisplacementLimit, ShortensWhatIsTooFarAndNothingElse) {
  const Array<Vec3> wanted = shaken(0.2 * e);
  Array<Vec3> position = wanted;
  Array<double> limit(mesh.size(), 0.2 * e);
  limit[7] = 0;
  limit_displacements(mesh.position, limit, position, bounded, job);
  std::size_t shortened = 0;
  for (std::size_t v = 0; v < mesh.size(); ++v) {
    const Vec3 displacement = position[v] - mesh.position[v];
    EXPECT_LE(displacement.norm(), limit[v] * (1 + 1e-12));
    EXPECT_NEAR(displacement.cross(wanted[v] - mesh.position[v]).norm(), 0, 1e-12);  // the direction stays
    EXPECT_EQ(position[v] != wanted[v], bounded[v] == 1);
    shortened += bounded[v];
  }
  EXPECT_EQ(position[7], mesh.position[7]);
  EXPECT_GT(shortened, 10u);
  EXPECT_LT(shortened, mesh.size());
}

TEST_F(DisplacementLimit, KeepsFacesUpright) {
  Array<Vec3> position = shaken(0.9 * e);
  const Array<Vec3> wanted = position;
  ASSERT_GT(turned(position), 20u);
  const Array<double> limit(mesh.size(), 0);
  keep_faces_upright(mesh, mesh.position, faces.normal, limit, position, bounded, job);
  EXPECT_EQ(turned(position), 0u);
  std::size_t kept = 0, partly = 0;
  for (std::size_t v = 0; v < mesh.size(); ++v) {
    EXPECT_EQ(position[v] != wanted[v], bounded[v] == 1);
    kept += bounded[v] == 0;
    partly += bounded[v] == 1 && position[v] != mesh.position[v];
  }
  EXPECT_GT(kept, 10u);    // only vertices of turned faces go back
  EXPECT_GT(partly, 10u);  // and no farther than it takes
}

// A face that noise has turned over may be turned back; without noise that reaches so far nothing can have turned it.
TEST_F(DisplacementLimit, LetsNoiseBeUndone) {
  const Array<Vec3> clean = mesh.position;
  const Array<UnitNormal> filtered = faces.normal;
  Index v = 5;
  for (const auto& f : mesh.face)
    if (f[0] == v || f[1] == v || f[2] == v) {
      mesh.position[v] = clean[f[0]] + clean[f[1]] + clean[f[2]] - clean[v] * 2;  // beyond the far edge of this face
      break;
    }
  faces.measure(mesh, mesh.position, job);
  ASSERT_GT(turned(clean), 0u);
  for (const bool noise : {true, false}) {
    Array<Vec3> position = clean;
    const Array<double> limit(mesh.size(), noise ? 2 * e : 0.01 * e);
    keep_faces_upright(mesh, mesh.position, filtered, limit, position, bounded, job);
    if (noise) {
      EXPECT_EQ(position[v], clean[v]);
    } else {
      EXPECT_EQ(turned(position), 0u);
    }
  }
}

}  // namespace
