// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces the guided filter's update of the vertices takes for folded, and how it opens them: against the rule of
// docs/guided.md with its numbers.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <mesh_tools/random.h>
#include <support/arrays_of.h>
#include <support/noisy_shapes.h>

#include "filters/guided/guided_settings.h"
#include "filters/guided/vertex_update.h"

namespace {

using namespace vcg_core::detail;

const vcg_core::Progress no_progress;

class Unfolding : public testing::TestWithParam<const char*> {
 protected:
  /// Normals in every direction, so that faces and normals meet at all angles.
  Unfolding() {
    mesh_tools::Random random(3);
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
      const double z = 2 * random.uniform() - 1;
      const double angle = 2 * std::acos(-1.0) * random.uniform();
      single.push_back(in_single({std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z}));
      normal.push_back(in_double(single.back()));
    }
  }

  double cosine(std::size_t f, const Array<Vec3>& position) const {
    const auto& v = mesh.face[f];
    const Vec3 cross = (position[v[1]] - position[v[0]]).cross(position[v[2]] - position[v[0]]);
    return cross.dot(normal[f]) / cross.norm();
  }

  std::vector<bool> at_folded_faces(const Array<Vec3>& position) const {
    std::vector<bool> result(mesh.size(), false);
    for (std::size_t f = 0; f < mesh.face.size(); ++f)
      if (cosine(f, position) < 0.2)
        for (const Index v : mesh.face[f]) result[v] = true;
    return result;
  }

  /// One update by the formulas: v += mean of n_f (n_f . (c_f - v)); at a fold also half way to the middle of the ring,
  /// less what of that lies along the normals of the faces.
  Array<Vec3> updated(const Array<Vec3>& position, const std::vector<bool>& folded) const {
    Array<Vec3> result = position;
    for (Index v = 0; v < mesh.size(); ++v) {
      Vec3 to_planes = Vec3::Zero(), to_middle = Vec3::Zero(), along_normals = Vec3::Zero();
      double faces = 0;
      for (std::size_t f = 0; f < mesh.face.size(); ++f) {
        const auto& corner = mesh.face[f];
        if (corner[0] != v && corner[1] != v && corner[2] != v) continue;
        const Vec3 sum = position[corner[0]] + position[corner[1]] + position[corner[2]];
        to_planes += normal[f] * normal[f].dot(sum / 3 - position[v]);
        to_middle += (sum - position[v]) / 2 - position[v];
        ++faces;
      }
      to_middle /= faces;
      for (std::size_t f = 0; f < mesh.face.size(); ++f)
        for (const Index corner : mesh.face[f])
          if (corner == v) along_normals += normal[f] * normal[f].dot(to_middle) / faces;
      result[v] += to_planes / faces;
      if (folded[v] && !mesh.topology.border[v]) result[v] += 0.5 * (to_middle - along_normals);
    }
    return result;
  }

  Job job{no_progress, 2};
  MeshArrays mesh = test_support::arrays_of(test_support::noisy_shape(GetParam(), 200, 0.2), job);
  Array<UnitNormal> single;
  Array<Vec3> normal;
  const Array<std::uint8_t> movable = Array<std::uint8_t>(mesh.size(), 1);
};

TEST_P(Unfolding, IsForVerticesOfFacesThatLookAwayFromTheirNormals) {
  Array<Vec3> position = mesh.position;
  update_positions(mesh, single, movable, 1, GuidedSettings{}, position, job);
  const Array<Vec3> expected = updated(mesh.position, at_folded_faces(mesh.position));
  for (Index v = 0; v < mesh.size(); ++v) EXPECT_LT((position[v] - expected[v]).norm(), 1e-12) << v;

  int barely_folded = 0, barely_upright = 0;
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    const double c = cosine(f, mesh.position);
    barely_folded += c > 0.1 && c < 0.2;
    barely_upright += c > 0.2 && c < 0.3;
  }
  EXPECT_GT(barely_folded, 3);
  EXPECT_GT(barely_upright, 3);
}

TEST_P(Unfolding, LooksForFoldsAnewAtEveryOtherUpdate) {
  Array<Vec3> position = mesh.position;
  update_positions(mesh, single, movable, 3, GuidedSettings{}, position, job);
  const std::vector<bool> first = at_folded_faces(mesh.position);
  Array<Vec3> expected = updated(updated(mesh.position, first), first);
  const std::vector<bool> second = at_folded_faces(expected);
  EXPECT_NE(first, second);
  expected = updated(expected, second);
  for (Index v = 0; v < mesh.size(); ++v) EXPECT_LT((position[v] - expected[v]).norm(), 1e-12) << v;
}

TEST_P(Unfolding, OffLeavesOnlyTheStepToThePlanes) {
  GuidedSettings settings;
  settings.unfold = false;
  Array<Vec3> position = mesh.position;
  update_positions(mesh, single, movable, 1, settings, position, job);
  const Array<Vec3> expected = updated(mesh.position, std::vector<bool>(mesh.size(), false));
  for (Index v = 0; v < mesh.size(); ++v) EXPECT_LT((position[v] - expected[v]).norm(), 1e-12) << v;
}

INSTANTIATE_TEST_SUITE_P(Shapes, Unfolding, testing::Values("sphere", "plane_delaunay"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
