// SPDX-License-Identifier: GPL-3.0-or-later
// Medians of values that are counted piece by piece.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <vcg_core/mesh/value_counts.h>

namespace {

using vcg_core::ValueCounts;

TEST(ValueCounts, OfPiecesGiveTheMedianOfAll) {
  std::mt19937 random(7);
  for (const double size : {1e-9, 0.003, 1.0, 700.0}) {
    std::lognormal_distribution<double> distribution(std::log(size), 0.5);
    std::vector<double> values;
    ValueCounts pieces[3], all;
    for (int i = 0; i < 200'001; ++i) {
      values.push_back(distribution(random));
      pieces[i % 7 % 3].add(values.back());
    }
    for (const ValueCounts& piece : pieces) all.add(piece);
    std::nth_element(values.begin(), values.begin() + 100'000, values.end());
    // A bin is a thousandth wide and holds about a hundred values there.
    EXPECT_NEAR(all.median() / values[100'000], 1, 1e-4) << size;
  }
}

TEST(ValueCounts, TakeWhatIsTooSmallOrTooLarge) {
  EXPECT_EQ(ValueCounts().median(), 0);
  ValueCounts zeros;
  for (int i = 0; i < 9; ++i) zeros.add(0);
  EXPECT_LT(zeros.median(), 1e-12);
  for (int i = 0; i < 100; ++i) zeros.add(1e30);
  EXPECT_GT(zeros.median(), 1e4);
  ValueCounts same;
  for (int i = 0; i < 5; ++i) same.add(0.25);
  EXPECT_NEAR(same.median(), 0.25, 0.25 / 1024);
}

}  // namespace
