// SPDX-License-Identifier: GPL-3.0-or-later
// The angle of two vectors against the C library's arc tangent in long double.

#include <angle.h>

#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

namespace {

using vcg_core::detail::angle_between;

constexpr double pi = 3.14159265358979323846;

TEST(Angle, IsExactWhereItCanBe) {
  EXPECT_EQ(angle_between(0, 1), 0);
  EXPECT_EQ(angle_between(0, -1), pi);
  EXPECT_EQ(angle_between(1, 0), pi / 2);
  EXPECT_EQ(angle_between(DBL_MIN, 1), DBL_MIN);
}

TEST(Angle, IsTheArcTangentAllAroundAndForAnyLengths) {
  for (int k = 0; k <= 200000; ++k) {
    const double phi = pi * k / 200000;
    for (const double length : {1e-150, 1.0, 1e150}) {
      const double cross = length * std::sin(phi);
      const double dot = length * std::cos(phi);
      ASSERT_NEAR(angle_between(cross, dot), static_cast<double>(std::atan2(1.0L * cross, 1.0L * dot)), 6e-16) << phi;
    }
  }
}

// As weights of needles' normals these count against each other, so no digit may be lost.
TEST(Angle, KeepsTheDigitsOfSmallAngles) {
  for (double cross = 0.4; cross > DBL_MIN; cross *= 0.37) {
    const auto expected = static_cast<double>(std::atan2(1.0L * cross, 1.0L));
    ASSERT_NEAR(angle_between(cross, 1), expected, 5e-16 * expected);
  }
}

}  // namespace
