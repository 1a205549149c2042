// SPDX-License-Identifier: GPL-3.0-or-later
// Noise that is correlated over some edges: what tells it from shape, and how much of it is found.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>
#include <support/arrays_of.h>
#include <support/mesh_types.h>
#include <support/packed.h>
#include <vcg_core/mesh/measures.h>
#include "filters/guided/correlated_noise.h"
#include "job.h"

namespace {

using namespace vcg_core::detail;
using test_support::FlatMesh;
using test_support::Point;

const vcg_core::Progress no_progress;

/// Fields of heights on a mesh.
class Heights {
 public:
  explicit Heights(const char* shape)
      : job_(no_progress, 2),
        flat_(test_support::flat(mesh_tools::make_shape(shape, 8000))),
        mesh_(test_support::arrays_of(flat_, job_)),
        rings_(mesh_, job_),
        seen_(mesh_.size(), 1) {}

  /// How far a field is taken for noise; `height` gives it at each vertex of the mesh as it was made. It is low-passed,
  /// and loses its widest waves, as these stay on a mesh that is filtered.
  template <class Height>
  double trust(const Height& height, int low_passes = 0) {
    Residual residual{Array<double>(mesh_.size()), seen_};
    for (std::size_t v = 0; v < mesh_.size(); ++v)
      residual.height[v] = height(flat_.points[mesh_.host_vertex[mesh_.first_copy(v)]]);
    residual.height = low_pass(rings_, std::move(residual.height), low_passes, job_);
    const Array<double> wide = low_pass(rings_, residual.height, 10, job_);
    for (std::size_t v = 0; v < mesh_.size(); ++v) residual.height[v] -= wide[v];
    const ResidualStatistics of = statistics_of(rings_, residual, job_);
    return trust_in(of, spread_of_noise(rings_, seen_, of.correlation, job_));
  }

 private:
  Job job_;
  FlatMesh flat_;
  MeshArrays mesh_;
  RingMeans rings_;
  Array<std::uint8_t> seen_;
};

class CorrelatedNoise : public testing::TestWithParam<const char*> {};

TEST_P(CorrelatedNoise, IsNoiseWhicheverWayItWasDrawn) {
  Heights heights(GetParam());
  for (const unsigned seed : {1u, 2u, 3u})
    for (const int low_passes : {1, 2, 4}) {
      std::mt19937 random(seed);
      std::normal_distribution<double> normal;
      EXPECT_GT(heights.trust([&](const Point&) { return normal(random); }, low_passes), 0.99) << seed;
    }
}

TEST_P(CorrelatedNoise, IsNeitherWavesNorDetailsNorOneSided) {
  Heights heights(GetParam());
  EXPECT_EQ(heights.trust([](const Point& p) { return std::sin(40 * p[0]) * std::sin(40 * p[1]); }), 0);
  EXPECT_EQ(heights.trust([](const Point& p) { return std::sin(30 * (p[0] + p[1] + p[2])); }), 0);
  EXPECT_EQ(heights.trust([](const Point& p) { return std::exp(-200 * (p[0] - 0.4) * (p[0] - 0.4)); }), 0);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  EXPECT_EQ(heights.trust([&](const Point&) { return std::exp(normal(random)); }, 2), 0);
  EXPECT_EQ(heights.trust([&](const Point& p) { return (p[0] > 0.3 ? 1 : 0.1) * normal(random); }, 2), 0);
}

INSTANTIATE_TEST_SUITE_P(Shapes, CorrelatedNoise, testing::Values("torus", "cube", "plane_random_diagonals"));

double estimate_over_truth(const char* shape, std::size_t vertices, double level, double correlation) {
  mesh_tools::Mesh mesh = mesh_tools::make_shape(shape, vertices);
  const double truth = level * mesh_tools::average_edge_length(mesh);
  mesh_tools::NoiseModel model;
  model.level = level;
  model.correlation = correlation;
  mesh_tools::add_noise(mesh, model);
  test_support::Packed<float, std::uint32_t> packed(test_support::flat(mesh));
  return vcg_core::estimate_noise(packed.view(), {}, 2) / truth;
}

TEST(MeshWithCorrelatedNoise, IsFoundWithItsSize) {
  for (const char* shape : {"cube", "sphere", "stepped_block", "torus"})
    for (const double correlation : {1.5, 2.0})
      for (const double level : {0.1, 0.2, 0.3})
        EXPECT_NEAR(estimate_over_truth(shape, 6000, level, correlation), 1, 0.3)
            << shape << " " << correlation << " " << level;
  for (const char* shape : {"cube", "sphere"}) EXPECT_NEAR(estimate_over_truth(shape, 6000, 0.2, 3), 1, 0.3) << shape;
}

// There are too few independent places to tell it from details.
TEST(MeshWithCorrelatedNoise, IsNotFoundOnSmallMeshes) { EXPECT_EQ(estimate_over_truth("cube", 1400, 0.2, 2), 0); }

}  // namespace
