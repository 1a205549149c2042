// The order in which the core keeps vertices, and the count of vertices in the same place that it gives.

#include <spatial_order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include <mesh_tools/random.h>
#include <vcg_core/detail/job.h>

namespace {

using vcg_core::detail::Array;
using vcg_core::detail::Index;
using vcg_core::detail::Job;
using vcg_core::detail::SpatialOrder;
using vcg_core::detail::Vec3;

const vcg_core::Progress no_progress;

SpatialOrder morton_order(const Array<Vec3>& points) {
  Job job(no_progress, 1);
  return vcg_core::detail::morton_order(points, job);
}

std::size_t count_coincident(const Array<Vec3>& points, const SpatialOrder& order) {
  Job job(no_progress, 1);
  return vcg_core::detail::count_coincident(points, order, job);
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

std::size_t count_by_comparing_all(const Array<Vec3>& points) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j)
      if (i != j && points[i] == points[j]) {
        ++count;
        break;
      }
  return count;
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
  const Array<Vec3> same(10, Vec3(1, 2, 3));
  EXPECT_EQ(morton_order(same).order.size(), 10u);
  EXPECT_EQ(count_coincident(same, morton_order(same)), 10u);
}

TEST(SpatialOrder, CountsCoincidentPointsAsComparingAllDoes) {
  for (const double cells : {3.0, 8.0, 30.0, 1000.0}) {
    const Array<Vec3> points = lattice_points(700, cells, 0.1);
    EXPECT_EQ(count_coincident(points, morton_order(points)), count_by_comparing_all(points)) << cells;
  }
}

// Nearer than a cell of the order, and still not the same place.
TEST(SpatialOrder, PointsInTheSameCellAreNotTheSame) {
  const Array<Vec3> points{{0, 0, 0}, {1e-9, 0, 0}, {1, 1, 1}, {1e-9, 0, 0}, {0, 1e-9, 0}};
  EXPECT_EQ(count_coincident(points, morton_order(points)), 2u);
}

}  // namespace
