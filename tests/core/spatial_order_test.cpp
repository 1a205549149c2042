// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the core keeps vertices, and which of them are one by it.

#include <spatial_order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <job.h>
#include <mesh_tools/random.h>
#include <vcg_core/errors.h>

#include <mesh/weld.h>

namespace {

using vcg_core::detail::Array;
using vcg_core::detail::Index;
using vcg_core::detail::Job;
using vcg_core::detail::SpatialOrder;
using vcg_core::detail::Vec3;
using vcg_core::detail::Welding;

const vcg_core::Progress no_progress;

SpatialOrder morton_order(const Array<Vec3>& points) {
  Job job(no_progress, 1);
  return vcg_core::detail::morton_order(points, job);
}

Welding weld(const Array<Vec3>& points, double distance = 0) {
  Job job(no_progress, 1);
  return vcg_core::detail::weld(points, morton_order(points).order, distance, job);
}

/// The vertex of each point, numbered by their first points: two assignments are equal if they join the same points.
std::vector<std::size_t> vertex_of_points(const Array<Vec3>& points, double distance) {
  const Array<Index> order = morton_order(points).order;
  const Welding welding = weld(points, distance);
  std::vector<std::size_t> vertex(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) vertex[order[i]] = welding.vertex[i];
  std::map<std::size_t, std::size_t> number;
  for (std::size_t& v : vertex) v = number.emplace(v, number.size()).first->second;
  return vertex;
}

/// Points of a coarse lattice, so that many fall together.
Array<Vec3> lattice_points(std::size_t count, double cells, double scale) {
  mesh_tools::Random random(11);
  Array<Vec3> points;
  for (std::size_t k = 0; k < count; ++k) {
    const auto coordinate = [&] { return std::floor(random.uniform() * cells) * scale; };
    const double x = coordinate();
    const double y = coordinate();
    points.emplace_back(x, y, coordinate());
  }
  return points;
}

/// The same by comparing all with all until nothing changes.
std::vector<std::size_t> vertex_by_comparing_all(const Array<Vec3>& points, double distance) {
  std::vector<std::size_t> vertex(points.size());
  std::iota(vertex.begin(), vertex.end(), std::size_t(0));
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (vertex[i] == vertex[j] || (points[i] - points[j]).squaredNorm() > distance * distance) continue;
        vertex[i] = vertex[j] = std::min(vertex[i], vertex[j]);
        changed = true;
      }
  }
  std::map<std::size_t, std::size_t> number;
  for (std::size_t& v : vertex) v = number.emplace(v, number.size()).first->second;
  return vertex;
}

TEST(SpatialOrder, IsAPermutationSortedByCode) {
  const Array<Vec3> points = lattice_points(5000, 1000, 1e-3);
  const auto [order, code] = morton_order(points);
  EXPECT_TRUE(std::is_sorted(code.begin(), code.end()));
  Array<Index> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted.size(), points.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) EXPECT_EQ(sorted[k], k);
}

TEST(SpatialOrder, KeepsNeighborsTogether) {
  const Array<Vec3> points = lattice_points(4096, 1e6, 1e-6);
  const auto order = morton_order(points).order;
  double in_order = 0;
  double as_given = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    in_order += (points[order[k]] - points[order[k - 1]]).norm();
    as_given += (points[k] - points[k - 1]).norm();
  }
  EXPECT_LT(in_order, 0.2 * as_given);
}

TEST(SpatialOrder, OfPointsInOnePlaceAndOfNone) {
  EXPECT_EQ(morton_order({}).order.size(), 0u);
  EXPECT_EQ(weld({}).vertices, 0u);
  EXPECT_EQ(weld({}, 1).vertices, 0u);
  const Array<Vec3> same(10, Vec3(1, 2, 3));
  EXPECT_EQ(morton_order(same).order.size(), 10u);
  EXPECT_EQ(weld(same).vertices, 1u);
}

// Many of them in one cell of the order: there the coordinates decide, and not who came first.
TEST(SpatialOrder, DoesNotDependOnTheOrderGiven) {
  Array<Vec3> points = lattice_points(500, 1e6, 1e-12);
  points.emplace_back(1, 1, 1);
  const auto placed = [](const Array<Vec3>& given) {
    Array<Vec3> result;
    for (const Index i : morton_order(given).order) result.push_back(given[i]);
    return result;
  };
  const Array<Vec3> before = placed(points);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(placed(points), before);
}

TEST(Weld, JoinsTheSamePointsAsComparingAllDoes) {
  for (const double cells : {3.0, 8.0, 30.0, 1000.0})
    for (const double distance : {0.0, 0.05, 0.1, 0.11, 0.15, 1.0}) {
      const Array<Vec3> points = lattice_points(300, cells, 0.1);
      const std::vector<std::size_t> expected = vertex_by_comparing_all(points, distance);
      if (std::count(expected.begin(), expected.end(), 0u) == static_cast<std::ptrdiff_t>(expected.size()))
        EXPECT_THROW(weld(points, distance), vcg_core::InvalidParameter);  // nothing of the surface would be left
      else
        EXPECT_EQ(vertex_of_points(points, distance), expected) << cells << " " << distance;
    }
}

// Nearer than a cell of the order, and still not the same place.
TEST(Weld, PointsInTheSameCellAreNotTheSame) {
  const Array<Vec3> points{{0, 0, 0}, {1e-9, 0, 0}, {1, 1, 1}, {1e-9, 0, 0}, {0, 1e-9, 0}};
  EXPECT_EQ(weld(points).vertices, 4u);
  EXPECT_EQ(weld(points, 1e-9).vertices, 2u);
}

TEST(Weld, ZerosOfBothSignsAreTheSamePlace) { EXPECT_EQ(weld({{0.0, 0, 0}, {-0.0, 0, 0}}).vertices, 1u); }

TEST(Weld, ADistanceThatTakesInEverythingIsRefused) {
  const Array<Vec3> points = lattice_points(3000, 1e6, 1e-6);
  EXPECT_THROW(weld(points, 10), vcg_core::InvalidParameter);
  EXPECT_EQ(weld(points, 1e-300).vertices, 3000u);
}

}  // namespace
