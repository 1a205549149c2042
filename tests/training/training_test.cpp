// SPDX-License-Identifier: GPL-3.0-or-later
// Training of the blend, on a small scale: what is learned does not hang on the seed, and is better than all that it
// chooses from.

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "ablation.h"
#include "network_trainer.h"
#include "samples.h"

namespace {

using namespace training;

constexpr std::size_t meshes = 100;
constexpr std::size_t faces = 1500;

Samples meshes_of(std::uint64_t seed) { return draw_samples(NoiseKind::white, seed, 0, meshes, nullptr, faces); }

double error_on(const Samples& kept_out, const Samples& learned, std::uint64_t seed) {
  std::ostringstream log;
  return mean_angle_to_truth(blend(train(learned, {40, 24}, 16, seed, log), kept_out), kept_out);
}

TEST(Training, AnotherSeedReachesTheSameQuality) {
  const Samples kept_out = draw_samples(NoiseKind::white, 5, 100, 100 + meshes, nullptr, faces);
  const double one = error_on(kept_out, meshes_of(1), 1);
  const double other = error_on(kept_out, meshes_of(2), 2);
  double best = 180;
  for (const Eigen::MatrixXf& candidate : kept_out.candidate)
    best = std::min(best, mean_angle_to_truth(candidate, kept_out));
  EXPECT_LT(one, 0.97 * best);
  EXPECT_LT(other, 0.97 * best);
  EXPECT_NEAR(one, other, 0.1 * best);
}

TEST(Training, ACandidateLeftOutLeavesTheDistancesBetweenTheOthers) {
  const Samples all = draw_samples(NoiseKind::white, 1, 0, 1, nullptr, 50);
  const Samples fewer = without_candidate(all, 2);
  const auto scalars = [](const Samples& samples) {
    const auto count = static_cast<Eigen::Index>(samples.candidate.size());
    return samples.input.rows() - count * (count - 1) / 2;
  };
  ASSERT_EQ(fewer.candidate.size() + 1, all.candidate.size());
  ASSERT_EQ(scalars(fewer), scalars(all));
  Eigen::Index row = 0;
  for (std::size_t a = 0; a < fewer.candidate.size(); ++a)
    for (std::size_t b = a + 1; b < fewer.candidate.size(); ++b, ++row)
      for (Eigen::Index i = 0; i < fewer.input.cols(); ++i)
        EXPECT_NEAR(fewer.input(row, i), (fewer.candidate[a].col(i) - fewer.candidate[b].col(i)).norm(), 1e-5);
  EXPECT_EQ(fewer.input.bottomRows(scalars(all)), all.input.bottomRows(scalars(all)));
}

TEST(Training, ScalarsLeftOutLeaveTheOthers) {
  const Samples all = draw_samples(NoiseKind::white, 1, 0, 1, nullptr, 50);
  const Samples fewer = without_scalars(all, 1, 3);
  const auto count = static_cast<Eigen::Index>(all.candidate.size());
  const Eigen::Index first = count * (count - 1) / 2;
  ASSERT_EQ(fewer.input.rows() + 2, all.input.rows());
  EXPECT_EQ(fewer.input.topRows(first + 1), all.input.topRows(first + 1));
  EXPECT_EQ(fewer.input.row(first + 1), all.input.row(first + 3));
}

}  // namespace
