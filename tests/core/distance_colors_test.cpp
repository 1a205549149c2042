// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/distance_colors.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <vector>

#include <gtest/gtest.h>

namespace {

using vcg_core::distance_colors;
using vcg_core::isoline_color;
using Faces = std::vector<std::array<std::size_t, 3>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// n x n vertices of the unit square, each cell split along one diagonal; distances from the corner at the origin.
struct Grid {
  explicit Grid(std::size_t side) : n(side) {
    for (std::size_t y = 0; y < n; ++y) {
      for (std::size_t x = 0; x < n; ++x) {
        distance.push_back(std::hypot(static_cast<double>(x), static_cast<double>(y)) / static_cast<double>(n - 1));
      }
    }
    for (std::size_t y = 0; y + 1 < n; ++y) {
      for (std::size_t x = 0; x + 1 < n; ++x) {
        const std::size_t v = y * n + x;
        faces.push_back({v, v + 1, v + n + 1});
        faces.push_back({v, v + n + 1, v + n});
      }
    }
  }
  std::size_t n;
  std::vector<double> distance;
  Faces faces;
};

TEST(DistanceColors, RampRunsFromRedToBlueAndStaysBright) {
  EXPECT_GT(vcg_core::distance_ramp(0).red, vcg_core::distance_ramp(0).blue);
  EXPECT_GT(vcg_core::distance_ramp(1).blue, vcg_core::distance_ramp(1).red);
  EXPECT_EQ(vcg_core::distance_ramp(-1), vcg_core::distance_ramp(0));
  EXPECT_EQ(vcg_core::distance_ramp(2), vcg_core::distance_ramp(1));
  for (int i = 0; i <= 100; ++i) {
    const vcg_core::Rgb c = vcg_core::distance_ramp(i / 100.0);
    EXPECT_GT(c.red + c.green + c.blue, 3 * 100) << i;
  }
}

TEST(DistanceColors, NoLinesWhenNoneAreAskedFor) {
  const Grid grid(20);
  for (const vcg_core::Rgb color : distance_colors(grid.distance, grid.faces, 0)) EXPECT_NE(color, isoline_color);
}

TEST(DistanceColors, NegativeNumberOfLinesIsRefused) {
  EXPECT_THROW(distance_colors({0, 1, 2}, {{0, 1, 2}}, -1), vcg_core::InvalidParameter);
}

TEST(DistanceColors, LinesLieAtEqualStepsAndNowhereElse) {
  const Grid grid(100);
  constexpr int isolines = 9;
  const auto colors = distance_colors(grid.distance, grid.faces, isolines);
  const double step = std::sqrt(2.0) / (isolines + 1);
  const double longest_edge = std::sqrt(2.0) / 99;
  for (std::size_t v = 0; v < colors.size(); ++v) {
    double off = infinity;
    for (int k = 1; k <= isolines; ++k) off = std::min(off, std::abs(grid.distance[v] - k * step));
    if (colors[v] == isoline_color) {
      EXPECT_LE(off, longest_edge / 2 + 1e-12) << v;
    } else {
      EXPECT_GT(off, 0.04 * step - 1e-12) << v;
    }
  }
}

/// No path of edges leads from the source to the far corner past the dark vertices: every line is unbroken.
TEST(DistanceColors, EveryLineIsUnbroken) {
  for (const std::size_t n : {10, 37, 100, 300}) {
    const Grid grid(n);
    const auto colors = distance_colors(grid.distance, grid.faces, 1);
    std::vector<std::vector<std::size_t>> neighbours(colors.size());
    for (const auto& face : grid.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        neighbours[face[k]].push_back(face[(k + 1) % 3]);
        neighbours[face[(k + 1) % 3]].push_back(face[k]);
      }
    }
    std::vector<bool> seen(colors.size(), false);
    std::queue<std::size_t> open;
    open.push(0);
    seen[0] = true;
    while (!open.empty()) {
      const std::size_t v = open.front();
      open.pop();
      for (const std::size_t w : neighbours[v]) {
        if (seen[w] || colors[w] == isoline_color) continue;
        seen[w] = true;
        open.push(w);
      }
    }
    EXPECT_FALSE(seen.back()) << n;
    EXPECT_NE(colors.front(), isoline_color);
  }
}

TEST(DistanceColors, EdgeThatCrossesSeveralLinesDarkensBothEnds) {
  const auto colors = distance_colors({0.05, 1.0, 0.0}, {{0, 1, 2}}, 5);
  EXPECT_EQ(colors[0], isoline_color);
  EXPECT_EQ(colors[1], isoline_color);
}

TEST(DistanceColors, UnreachableVerticesAreGreyAndTheirQualityIsFinite) {
  const auto colors = distance_colors({0, 1, infinity, infinity}, {{0, 1, 2}, {1, 2, 3}}, 3);
  EXPECT_EQ(colors[2], vcg_core::unreachable_color);
  EXPECT_EQ(colors[3], vcg_core::unreachable_color);
  EXPECT_EQ(vcg_core::distance_quality(infinity), -1);
  EXPECT_EQ(vcg_core::distance_quality(2.5), 2.5);
  EXPECT_EQ(vcg_core::distance_quality(1e39), 1e39);
  EXPECT_EQ(vcg_core::distance_quality<float>(1e39), -1);  // an infinity in single precision
  EXPECT_EQ(vcg_core::distance_quality<float>(2.5), 2.5f);
}

TEST(DistanceColors, OneReachableVertexIsTheSource) {
  const auto colors = distance_colors({infinity, 0, infinity}, {}, 10);
  EXPECT_EQ(colors[1], vcg_core::distance_ramp(0));
}

}  // namespace
