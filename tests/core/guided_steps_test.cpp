// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of the guided filter, each against a naive reference: the equations of docs/guided.md as they stand there.

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <job.h>
#include <mesh_arrays.h>
#include <support/arrays_of.h>
#include <support/noisy_shapes.h>
#include <support/unpacked.h>

#include "filters/guided/attribute_smoothing.h"
#include "filters/guided/detail_recovery.h"
#include "filters/guided/face_geometry.h"
#include "filters/guided/face_neighborhoods.h"
#include "filters/guided/faces_around.h"
#include "filters/guided/guide_normals.h"
#include "filters/guided/normal_filter.h"
#include "filters/guided/packed_normal.h"
#include "filters/guided/range_weight.h"
#include "filters/guided/vertex_update.h"
#include "vertex_normals.h"

namespace {

using namespace vcg_core::detail;
using test_support::FlatMesh;

const vcg_core::Progress no_progress;

using test_support::arrays_of;

std::vector<Index> list_of(const FaceLists& lists, Index f) {
  const FaceLists::Block& block = lists.block(f / FaceLists::block_size);
  std::vector<Index> list;
  for_each_list(block, [&](std::size_t i, std::size_t first, std::size_t length) {
    if (block.first + i != f) return;
    for (std::size_t k = first; k < first + length; ++k) list.push_back(block.face(block.entry[k]));
  });
  return list;
}

class GuidedSteps : public testing::Test {
 protected:
  GuidedSteps() {
    faces.measure(mesh, mesh.position, job);
    across = faces_across(mesh, job);
    spacing = local_spacing(mesh, true, 0, job);
    within = faces_within(mesh, across, mesh.position, spacing, 1.9, job);
    movable.assign(mesh.size(), 1);
  }

  std::set<Index> naive_around(Index f) const {
    std::set<Index> result;
    for (Index g = 0; g < mesh.face.size(); ++g)
      for (const Index v : mesh.face[f])
        for (const Index w : mesh.face[g])
          if (v == w) result.insert(g);
    return result;
  }

  Vec3 centroid(Index f) const { return centroid_of(mesh, mesh.position, f); }

  Job job{no_progress, 2};
  MeshArrays mesh = arrays_of(test_support::noisy_shape("cube", 400), job);
  WholeMedians medians{mesh};
  FaceGeometry faces;
  Array<Index> across;
  Array<double> spacing;
  FaceLists within;
  Array<std::uint8_t> movable;
};

TEST(GuidedWeight, IsNearlyGaussian) {
  for (double x = 0; x < 50; x += 0.01) EXPECT_NEAR(nearly_exp_of_minus(x), std::exp(-x), 0.009) << x;
  EXPECT_EQ(nearly_exp_of_minus(0.0), 1);
  EXPECT_EQ(nearly_exp_of_minus(1e300), 0);
}

TEST_F(GuidedSteps, FacesAroundShareAVertex) {
  FacesAround around(mesh, across);
  for (Index f = 0; f < mesh.face.size(); ++f) {
    const Array<Index>& list = around.find(f);
    const std::set<Index> found(list.begin(), list.end());
    EXPECT_EQ(found, naive_around(f));
    EXPECT_EQ(found.size(), list.size());
    EXPECT_EQ(list.front(), f);
    for (Index g = 0; g < mesh.face.size(); ++g) ASSERT_EQ(around.found(g), found.count(g) == 1);
  }
}

TEST_F(GuidedSteps, FacesAcrossShareTheEdge) {
  for (Index corner = 0; corner < across.size(); ++corner) {
    ASSERT_NE(across[corner], no_face);  // a closed mesh
    const auto& g = mesh.face[across[corner]];
    for (const Index end : {next_in_face(corner), previous_in_face(corner)})
      EXPECT_EQ(std::count(g.begin(), g.end(), vertex_of(mesh, end)), 1);
    EXPECT_NE(across[corner], corner / 3);
  }
}

// Growing by faces around, from the face itself, as long as centroids stay inside the radius.
TEST_F(GuidedSteps, FacesWithinAreTheConnectedBall) {
  for (Index f = 0; f < mesh.face.size(); ++f) {
    const double radius = 1.9 * spacing[f];
    std::set<Index> ball{f};
    for (std::size_t before = 0; before != ball.size();) {
      before = ball.size();
      std::set<Index> grown = ball;
      for (const Index g : ball)
        for (const Index h : naive_around(g))
          if ((centroid(h) - centroid(f)).norm() < radius) grown.insert(h);
      ball = grown;
    }
    if (ball.size() < 4)
      for (const Index h : naive_around(f)) ball.insert(h);
    const std::vector<Index> list = list_of(within, f);
    EXPECT_EQ(std::set<Index>(list.begin(), list.end()), ball) << f;
    EXPECT_EQ(list.size(), ball.size());
    EXPECT_EQ(list.front(), f);
  }
}

// By weights of 16 bits; packed normals are exact to 7e-5.
TEST_F(GuidedSteps, FilteredNormalsAreTheWeightedMean) {
  const ListWeights weight = closeness_weights(within, mesh, mesh.position, faces.area, spacing, 1, job);
  const Array<UnitNormal> guide = guide_normals(mesh, across, faces, GuidedSettings{}, medians, job);
  const Array<UnitNormal> filtered = filter_normals(within, weight, guide, faces.normal, 0.4, job);
  const Array<UnitNormal> by_itself = filter_normals(within, weight, faces.normal, faces.normal, 0.4, job);
  const Array<UnitNormal> mean = mean_of_neighbourhoods(within, weight, faces.normal, job);
  Array<PackedNormal> packed;
  for (const UnitNormal& n : faces.normal) packed.push_back(vcg_core::detail::packed(n));
  const Array<PackedNormal> packed_by_itself = filter_normals(within, weight, packed, packed, 0.4, job);
  const Array<PackedNormal> packed_mean = mean_of_neighbourhoods(within, weight, packed, job);
  for (Index f = 0; f < mesh.face.size(); ++f) {
    Vec3 sum = Vec3::Zero(), of_itself = Vec3::Zero(), of_all = Vec3::Zero();
    for (const Index j : list_of(within, f)) {
      const double distance = (centroid(f) - centroid(j)).norm() / spacing[f];
      const double difference = (guide[f] - guide[j]).norm() / 0.4;
      const double own = (faces.normal[f] - faces.normal[j]).norm() / 0.4;
      const Vec3 close = faces.area[j] * nearly_exp_of_minus(distance * distance / 2) * in_double(faces.normal[j]);
      of_all += close;
      sum += nearly_exp_of_minus(difference * difference / 2) * close;
      of_itself += nearly_exp_of_minus(own * own / 2) * close;
    }
    EXPECT_LT((in_double(by_itself[f]) - of_itself.normalized()).norm(), 2e-5);
    EXPECT_LT((in_double(filtered[f]) - sum.normalized()).norm(), 2e-5);
    EXPECT_LT((in_double(mean[f]) - of_all.normalized()).norm(), 2e-5);
    EXPECT_LT((test_support::unpacked(packed_by_itself[f]) - of_itself.normalized()).norm(), 1.5e-4);
    EXPECT_LT((test_support::unpacked(packed_mean[f]) - of_all.normalized()).norm(), 1.5e-4);
  }
}

TEST_F(GuidedSteps, FacesTooTinyForWeightsKeepTheirNormals) {
  for (const double factor : {1e-20, 1e-38, 1e-45, 1e-300}) {
    Array<double> area = faces.area;
    for (double& a : area) a *= factor;
    const ListWeights weight = closeness_weights(within, mesh, mesh.position, area, spacing, 1, job);
    const bool have_weight = std::any_of(weight.begin(), weight.end(), [](std::uint16_t w) { return w > 0; });
    EXPECT_EQ(have_weight, factor == 1e-20) << factor;
    const Array<UnitNormal> mean = mean_of_neighbourhoods(within, weight, faces.normal, job);
    if (!have_weight) {
      EXPECT_EQ(mean, faces.normal) << factor;
    }
  }
}

TEST_F(GuidedSteps, GuidesAreMeansOfTheMostConsistentPatch) {
  GuidedSettings settings;
  settings.guard_thin_parts = false;
  const Array<UnitNormal> guide = guide_normals(mesh, across, faces, settings, medians, job);
  const auto patch = [&](Index center) {
    Vec3 sum = Vec3::Zero();
    for (const Index g : naive_around(center)) sum += faces.area[g] * in_double(faces.normal[g]);
    const Vec3 mean = sum.normalized();
    double widest = 0, jumps = 1e-9, largest = 0;
    for (const Index g : naive_around(center)) {
      widest = std::max(widest, (in_double(faces.normal[g]) - mean).norm());
      for (Index k = 0; k < 3; ++k) {
        const Index h = across[3 * g + k];
        if (h < g || naive_around(center).count(h) == 0) continue;
        const double jump = (faces.normal[g] - faces.normal[h]).norm();
        jumps += jump;
        largest = std::max(largest, jump);
      }
    }
    return std::make_pair(widest * largest / jumps, mean);
  };
  for (Index f = 0; f < mesh.face.size(); f += 7) {
    double best = 1e300;
    Vec3 expected = Vec3::Zero();
    for (const Index g : naive_around(f)) {
      const auto [inconsistency, mean] = patch(g);
      if (inconsistency >= best) continue;
      best = inconsistency;
      expected = mean;
    }
    EXPECT_LT((in_double(guide[f]) - expected).norm(), 1e-7) << f;  // guides are in single precision
  }
}

TEST_F(GuidedSteps, UpdateMovesToThePlanesOfTheFaces) {
  GuidedSettings settings;
  settings.unfold = false;
  Array<Vec3> position = mesh.position;
  movable[5] = 0;
  const UnitNormal single = in_single(Vec3(1, 2, 3).normalized());
  const Vec3 normal = in_double(single);
  update_positions(mesh, Array<UnitNormal>(mesh.face.size(), single), movable, 1, settings, position, job);
  for (Index v = 0; v < mesh.size(); ++v) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const auto& f : mesh.face) {
      if (f[0] != v && f[1] != v && f[2] != v) continue;
      const Vec3 centroid = (mesh.position[f[0]] + mesh.position[f[1]] + mesh.position[f[2]]) / 3;
      sum += normal * normal.dot(centroid - mesh.position[v]);
      ++count;
    }
    const Vec3 expected = v == 5 ? mesh.position[v] : Vec3(mesh.position[v] + sum / count);
    EXPECT_LT((position[v] - expected).norm(), 1e-12);
  }
}

// A vertex pulled over to the far side of its ring leaves folded faces in a plane; the update opens them.
TEST(GuidedUnfolding, OpensFoldsWithinThePlane) {
  Job job{no_progress, 1};
  const FlatMesh flat = test_support::noisy_shape("plane_slash", 121, 0);
  MeshArrays mesh = arrays_of(flat, job);
  Array<Vec3> position = mesh.position;
  Index moved = 0;
  for (Index v = 0; v < mesh.size(); ++v)
    if ((position[v] - Vec3(0.5, 0.5, 0)).norm() < (position[moved] - Vec3(0.5, 0.5, 0)).norm()) moved = v;
  position[moved] += Vec3(0.17, 0.03, 0);
  const Array<UnitNormal> normal(mesh.face.size(), UnitNormal::UnitZ());
  Array<std::uint8_t> movable(mesh.size());
  for (Index v = 0; v < mesh.size(); ++v) movable[v] = !mesh.topology.border[v];
  const auto folds = [&] {
    FaceGeometry faces;
    faces.measure(mesh, position, job);
    return std::count_if(faces.normal.begin(), faces.normal.end(), [](const UnitNormal& n) { return n[2] < 0; });
  };
  ASSERT_GT(folds(), 0);
  update_positions(mesh, normal, movable, 30, GuidedSettings{}, position, job);
  EXPECT_EQ(folds(), 0);
  for (const Vec3& p : position) EXPECT_EQ(p[2], 0);
}

TEST(GuidedDetail, WhiteNoiseStaysOutAndShapeComesBack) {
  Job job{no_progress, 1};
  const MeshArrays noisy = arrays_of(test_support::noisy_shape("plane_delaunay", 2000, 0.2), job);
  Array<Vec3> flat = noisy.position;
  for (Vec3& p : flat) p[2] = 0;
  const Array<std::uint8_t> movable(noisy.size(), 1);
  const double e = noisy.topology.average_edge_length;
  const auto rms = [&](const Array<Vec3>& position, const auto& height) {
    double sum = 0;
    for (const Vec3& p : position) sum += std::pow(p[2] - height(p), 2);
    return std::sqrt(sum / static_cast<double>(position.size())) / e;
  };
  Array<Vec3> position = flat;
  WholeMedians medians(noisy), with_wave_medians(noisy);
  recover_detail(noisy, noisy.position, movable, GuidedSettings{}, medians, position, job);
  EXPECT_LT(rms(position, [](const Vec3&) { return 0.0; }), 0.03);

  const auto wave = [&](const Vec3& p) { return 0.5 * e * std::sin(30 * p[0]) * std::sin(30 * p[1]); };
  Array<Vec3> with_wave = noisy.position;
  for (Vec3& p : with_wave) p[2] += wave(p);
  position = flat;
  const double lost = rms(position, wave);
  recover_detail(noisy, with_wave, movable, GuidedSettings{}, with_wave_medians, position, job);
  EXPECT_LT(rms(position, wave), 0.6 * lost);
}

TEST(GuidedColor, DoesNotBleedOverAnEdge) {
  Job job{no_progress, 1};
  const MeshArrays mesh = arrays_of(test_support::noisy_shape("cube", 2000, 0), job);
  VertexAttributes attributes;
  attributes.has_scalar = true;
  double top = -1e300;
  for (const Vec3& p : mesh.position) top = std::max(top, p[2]);
  const double e = mesh.topology.average_edge_length;
  Array<double> truth;
  for (Index v = 0; v < mesh.size(); ++v) {
    truth.push_back(mesh.position[v][2] > top - 0.1 * e ? 100 : 0);
    attributes.value.push_back(truth.back() + (v % 2 == 0 ? 10 : -10));  // noise
  }
  const Array<std::uint8_t> movable(mesh.size(), 1);
  smooth_attributes(mesh, mesh.position, movable, GuidedSettings{}, attributes, job);
  const Array<Vec3> normal = vertex_normals(mesh, mesh.position, job);
  double inside_top = 0, sides = 0;
  int top_count = 0, side_count = 0;
  for (Index v = 0; v < mesh.size(); ++v) {
    if (normal[v][2] > 0.999) inside_top += std::abs(attributes.value[v] - truth[v]), ++top_count;
    if (std::abs(normal[v][2]) < 0.001) sides += std::abs(attributes.value[v] - truth[v]), ++side_count;
  }
  ASSERT_GT(top_count, 100);
  ASSERT_GT(side_count, 400);
  EXPECT_LT(inside_top / top_count, 5);  // the noise of 10 went, the 0 of the sides did not come
  EXPECT_LT(sides / side_count, 5);
}

}  // namespace
