// SPDX-License-Identifier: GPL-3.0-or-later
// The three weights and their product.

#include <filters/weights.h>

#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

namespace {

using vcg_core::GaussianForm;
using vcg_core::detail::GaussianWeights;

TEST(Weights, AreOneForTheVertexItself) {
  for (const double sigma : {DBL_TRUE_MIN, 1e-100, 1.0, 1e100, DBL_MAX})
    for (const GaussianForm form : {GaussianForm::standard_deviation, GaussianForm::printed})
      EXPECT_EQ(GaussianWeights(sigma, sigma, sigma, form).product(0, 0, 0), 1);
}

// One standard deviation away a Gaussian has fallen to exp(-1/2).
TEST(Weights, FallToOneOverTheRootOfEAtOneStandardDeviation) {
  const GaussianWeights weights(2, 0.5, 0.25, GaussianForm::standard_deviation);
  EXPECT_DOUBLE_EQ(weights.product(4, 0, 0), std::exp(-0.5));
  EXPECT_DOUBLE_EQ(weights.product(0, 0.5, 0), std::exp(-0.5));
  EXPECT_DOUBLE_EQ(weights.product(0, -0.5, 0), std::exp(-0.5));
  EXPECT_DOUBLE_EQ(weights.product(0, 0, 0.25), std::exp(-0.5));
  EXPECT_DOUBLE_EQ(weights.product(4, 0.5, 0.25), std::exp(-1.5));
}

// As printed, W_c and W_s lack the 2, W_n has it.
TEST(Weights, AsPrinted) {
  const GaussianWeights weights(2, 0.5, 0.25, GaussianForm::printed);
  EXPECT_DOUBLE_EQ(weights.product(4, 0, 0), std::exp(-1));
  EXPECT_DOUBLE_EQ(weights.product(0, 0.5, 0), std::exp(-1));
  EXPECT_DOUBLE_EQ(weights.product(0, 0, 0.25), std::exp(-0.5));
}

TEST(Weights, VanishOrStayOneAtTheEndsOfTheRange) {
  EXPECT_EQ(GaussianWeights(DBL_TRUE_MIN, 1, 1, GaussianForm::standard_deviation).product(1, 0, 0), 0);
  EXPECT_EQ(GaussianWeights(1, DBL_TRUE_MIN, 1, GaussianForm::standard_deviation).product(0, 1, 0), 0);
  EXPECT_EQ(GaussianWeights(1, 1, DBL_TRUE_MIN, GaussianForm::standard_deviation).product(0, 0, 1), 0);
  EXPECT_EQ(GaussianWeights(DBL_MAX, DBL_MAX, DBL_MAX, GaussianForm::standard_deviation).product(1, 1, 1), 1);
}

}  // namespace
