// SPDX-License-Identifier: GPL-3.0-or-later
// Same input, same bits, whatever the number of threads.

#include <tuple>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/noisy_shapes.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>

namespace {

using namespace test_support;

class Determinism : public testing::TestWithParam<SmoothingPath> {};

TEST_P(Determinism, SameBitsForAnyNumberOfThreads) {
  for (const char* const shape : {"cad_part", "plane_delaunay"}) {
    const FlatMesh mesh = noisy_shape(shape, 3000);
    vcg_core::SmoothingParameters parameters = GetParam().parameters;
    parameters.iterations = 2;
    parameters.threads = 1;
    const FlatMesh expected = smoothed(mesh, parameters);
    for (const int threads : {2, 3, 8, 0}) {
      parameters.threads = threads;
      EXPECT_TRUE(same_bits(smoothed(mesh, parameters), expected)) << shape << " with " << threads << " threads";
    }
  }
}

// More threads than there is work for, and than a small system gives.
TEST_P(Determinism, ManyThreadsOnASmallMesh) {
  const FlatMesh mesh = noisy_shape("sphere", 100);
  vcg_core::SmoothingParameters parameters = GetParam().parameters;
  parameters.threads = 1;
  const FlatMesh expected = smoothed(mesh, parameters);
  parameters.threads = 100;
  EXPECT_TRUE(same_bits(smoothed(mesh, parameters), expected));
}

// The report is a result as well: its sums do not depend on who adds them up.
TEST_P(Determinism, SameReportForAnyNumberOfThreads) {
  const FlatMesh shape = noisy_shape("stepped_block", 20000);
  vcg_core::SmoothingParameters parameters = GetParam().parameters;
  parameters.sigma_c = 1;
  const auto report = [&](int threads) {
    DoubleMesh mesh;
    fill(mesh, shape);
    parameters.threads = threads;
    return vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
  };
  const vcg_core::SmoothingReport one = report(1);
  const vcg_core::SmoothingReport three = report(3);
  EXPECT_EQ(one.average_edge_length, three.average_edge_length);
  EXPECT_EQ(one.rms_displacement, three.rms_displacement);
  EXPECT_EQ(one.max_displacement, three.max_displacement);
  EXPECT_EQ(one.volume_after, three.volume_after);
  EXPECT_EQ(one.flipped_faces, three.flipped_faces);
  EXPECT_EQ(one.coordinate_spacing, three.coordinate_spacing);
  EXPECT_EQ(one.warnings(), three.warnings());
}

INSTANTIATE_TEST_SUITE_P(Paths, Determinism, testing::ValuesIn(smoothing_paths()), name_of_path);

}  // namespace
