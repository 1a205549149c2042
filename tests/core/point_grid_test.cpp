// SPDX-License-Identifier: GPL-3.0-or-later
#include <point_grid.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <mesh_tools/random.h>

namespace {

using namespace vcg_core::detail;

/// `count` points in a cube of side `size` around `middle`.
void add_cloud(Array<Vec3>& points, std::size_t count, const Vec3& middle, double size) {
  mesh_tools::Random random(points.size() + 1);
  for (std::size_t k = 0; k < count; ++k) {
    const double x = random.uniform();
    const double y = random.uniform();
    const double z = random.uniform();
    points.push_back(middle + (Vec3(x, y, z) - Vec3::Constant(0.5)) * size);
  }
}

Array<Index> all_of(const Array<Vec3>& points) {
  Array<Index> index(points.size());
  for (Index i = 0; i < index.size(); ++i) index[i] = i;
  return index;
}

std::vector<Index> found_near(PointGrid::Search& search, const Vec3& center) {
  std::vector<Index> found;
  search.for_each_near(center, [&](Index i, const Vec3&) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

/// Against looking at all points; centres are the points, and places beside them.
void expect_all_found(const Array<Vec3>& points, double radius) {
  const PointGrid grid(points, all_of(points), radius);
  PointGrid::Search search(grid);
  for (const Vec3& point : points)
    for (const Vec3& center : {point, Vec3(point + Vec3(0.9, -0.4, 1.7) * radius), Vec3(point * 3)}) {
      std::vector<Index> expected;
      for (Index i = 0; i < points.size(); ++i)
        if ((points[i] - center).norm() < radius * (1 - 1e-12)) expected.push_back(i);
      std::vector<Index> found = found_near(search, center);
      EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
      for (const Index i : found) EXPECT_LE((points[i] - center).norm(), radius * (1 + 1e-12));
    }
}

TEST(PointGrid, FindsAllPointsWithinTheRadius) {
  Array<Vec3> points;
  add_cloud(points, 400, Vec3::Zero(), 1);
  for (const double radius : {0.01, 0.1, 0.7, 5.0}) expect_all_found(points, radius);
}

TEST(PointGrid, FindsThemInPartsThatLieFarApart) {
  for (const double apart : {1e5, 1e8, 1e10}) {
    Array<Vec3> points;
    add_cloud(points, 150, Vec3::Zero(), 1);
    add_cloud(points, 150, Vec3(apart, 0, -apart / 3), 1);
    add_cloud(points, 100, Vec3(apart, apart, 3), 1);
    points.emplace_back(apart / 7, 0, 0);
    expect_all_found(points, 0.2);
  }
}

TEST(PointGrid, FindsPointsAtTheSamePlaceHoweverFarOthersAre) {
  Array<Vec3> points(5, Vec3(1, 2, 3));
  points.emplace_back(-1e30, 1e30, 0);
  const PointGrid grid(points, all_of(points), 1e-3);
  PointGrid::Search search(grid);
  EXPECT_EQ(found_near(search, points[0]), (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_EQ(found_near(search, points[5]), (std::vector<Index>{5}));
}

TEST(PointGrid, OfNoPointsFindsNone) {
  const Array<Vec3> points(3, Vec3::Zero());
  const PointGrid grid(points, {}, 1);
  PointGrid::Search search(grid);
  EXPECT_TRUE(found_near(search, points[0]).empty());
}

// One far point used to make the cells as wide as the whole rest.
TEST(PointGrid, LooksAtFewMorePointsForAPointFarAway) {
  Array<Vec3> points;
  add_cloud(points, 20000, Vec3(5e9, 5e9, 5e9), 30);
  const auto looks = [&] {
    const PointGrid grid(points, all_of(points), 1);
    PointGrid::Search search(grid);
    for (std::size_t k = 0; k < 20000; ++k) search.for_each_near(points[k], [](Index, const Vec3&) {});
    return search.looks();
  };
  const std::size_t alone = looks();
  points.emplace_back(0, 0, 0);
  EXPECT_LT(looks(), alone + alone / 10);
}

}  // namespace
