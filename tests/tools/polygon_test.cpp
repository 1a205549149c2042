// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting polygons into triangles: the same surface, nothing twice, nothing turned over.

#include "io/polygon.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <mesh_tools/random.h>

namespace {

using mesh_tools::io::triangulate;
using vcg::Point3d;
using Polygon = std::vector<Point3d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Point3d newell(const Polygon& polygon) {
  Point3d sum(0, 0, 0);
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += polygon[i] ^ polygon[(i + 1) % polygon.size()];
  return sum / 2;
}

Polygon flat(const std::vector<std::pair<double, double>>& places) {
  Polygon polygon;
  for (const auto& [x, y] : places) polygon.emplace_back(x, y, 0);
  return polygon;
}

Triangles fan(std::uint32_t corners) {
  Triangles triangles;
  for (std::uint32_t k = 2; k < corners; ++k) triangles.push_back({0, k - 1, k});
  return triangles;
}

/// As many triangles as there must be, each corner in one of them, and together a disc whose rim is the polygon.
void expect_disc(std::size_t corners, const Triangles& triangles) {
  ASSERT_EQ(triangles.size(), corners - 2);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % static_cast<std::uint32_t>(corners);
    ASSERT_EQ((edges[{i, next}]), 1) << i;
    ASSERT_EQ((edges[{next, i}]), 0) << i;
    edges.erase({i, next});
    edges.erase({next, i});
  }
  for (const auto& [edge, count] : edges) ASSERT_EQ((edges.at({edge.second, edge.first})), count);
}

/// A disc whose triangles all face the polygon's side and have its area: of a plane polygon the polygon itself.
void expect_cut(const Polygon& polygon) {
  const Triangles triangles = triangulate(polygon);
  expect_disc(polygon.size(), triangles);
  const Point3d normal = newell(polygon);
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const Point3d part = (polygon[b] - polygon[a]) ^ (polygon[c] - polygon[a]);
    EXPECT_GE(part * normal, -1e-9 * normal.SquaredNorm());
    area += part.Norm() / 2;
  }
  EXPECT_NEAR(area, normal.Norm(), 1e-9 * normal.Norm());
}

/// Turned anywhere, begun at any corner.
void expect_cut_in_space(const Polygon& polygon) {
  mesh_tools::Random random(7);
  for (std::size_t start = 0; start < std::min<std::size_t>(polygon.size(), 12); ++start) {
    Point3d x(random.normal(), random.normal(), random.normal()), y(random.normal(), random.normal(), random.normal());
    x.Normalize();
    y = (y - x * (x * y)).Normalize();
    Polygon turned;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point3d& p = polygon[(start + i) % polygon.size()];
      turned.push_back(x * p[0] + y * p[1] + Point3d(3, 2, 1));
    }
    expect_cut(turned);
    expect_cut({turned.rbegin(), turned.rend()});
  }
}

Polygon convex(std::uint64_t seed, std::size_t corners) {
  mesh_tools::Random random(seed);
  std::set<double> angles;
  while (angles.size() < corners) angles.insert(2 * M_PI * random.uniform());
  Polygon polygon;
  for (const double angle : angles) polygon.emplace_back(3 * std::cos(angle), std::sin(angle), 0.5 * std::cos(angle));
  return polygon;
}

TEST(CutPolygon, convex_ones_become_fans) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Polygon polygon = convex(seed, 3 + seed % 20);
    EXPECT_EQ(triangulate(polygon), fan(static_cast<std::uint32_t>(polygon.size()))) << seed;
  }
  // Corners in the middle of edges, and four corners that are not in one plane.
  EXPECT_EQ(triangulate(flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 1}})), fan(7));
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}), fan(4));
}

TEST(CutPolygon, a_fan_is_kept_where_it_suits_a_concave_one) {
  EXPECT_EQ(triangulate(flat({{2, 1}, {0, 4}, {0, 0}, {4, 0}, {4, 4}})), fan(5));
}

TEST(CutPolygon, concave_ones_keep_their_area) {
  expect_cut_in_space(flat({{0, 4}, {0, 0}, {4, 0}, {4, 4}, {2, 1}}));
  expect_cut_in_space(flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}));
  // Edges on one line with others, as of walls with doors.
  expect_cut_in_space(
      flat({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 0}, {3, 0}, {3, 1}, {4, 1}, {4, 0}, {5, 0}, {5, 2}, {0, 2}}));
}

TEST(CutPolygon, random_stars_keep_their_area) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    mesh_tools::Random random(seed);
    Polygon polygon;
    const std::size_t corners = 4 + seed;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(corners),
                   radius = 0.1 + random.uniform();
      polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    expect_cut_in_space(polygon);
  }
}

TEST(CutPolygon, combs_and_spirals_keep_their_area) {
  Polygon comb;
  constexpr int teeth = 1000;
  for (int i = 0; i < teeth; ++i) {
    comb.emplace_back(i, 0, 0);
    comb.emplace_back(i + 0.5, 5 + i % 3, 0);
  }
  comb.emplace_back(teeth, 0, 0);
  comb.emplace_back(teeth, 10, 0);
  comb.emplace_back(0, 10, 0);
  expect_cut(comb);
  Polygon spiral;
  constexpr int steps = 400;
  for (int i = 0; i <= 2 * steps; ++i) {
    const bool back = i > steps;
    const double angle = 0.1 * (back ? 2 * steps - i : i), radius = 1 + 0.1 * angle + (back ? 0.3 : 0);
    spiral.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  expect_cut(spiral);
}

TEST(CutPolygon, a_hole_that_a_bridge_joins_to_the_rim_stays_open) {
  const Polygon polygon = flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
  double area = 0;
  const Triangles triangles = triangulate(polygon);
  expect_disc(polygon.size(), triangles);
  for (const auto& [a, b, c] : triangles) {
    const Point3d part = (polygon[b] - polygon[a]) ^ (polygon[c] - polygon[a]);
    EXPECT_GE(part[2], 0);
    const Point3d middle = (polygon[a] + polygon[b] + polygon[c]) / 3;
    if (part[2] > 0) {
      EXPECT_TRUE(std::abs(middle[0] - 2) >= 1 || std::abs(middle[1] - 2) >= 1);
    }
    area += part[2] / 2;
  }
  EXPECT_DOUBLE_EQ(area, 12);
}

TEST(CutPolygon, degenerate_ones_are_cut_somehow) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN(), much = std::numeric_limits<double>::max();
  const std::vector<Polygon> polygons = {
      Polygon(9, Point3d(1, 2, 3)),
      flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 0}}),
      flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),                           // a bow tie
      flat({{0, 0}, {3, 0}, {3, 3}, {1, -1}, {1, 4}, {2, 1}, {0, 3}}),  // crosses itself
      flat({{0, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 0}, {0, 1}}),           // edges twice
      flat({{0, 0}, {none, 0}, {1, 1}, {0, 1}, {0.1, 0.5}}),
      flat({{0, 0}, {much, 0}, {much, much}, {0, much}, {1, 1}})};
  for (const Polygon& polygon : polygons) expect_disc(polygon.size(), triangulate(polygon));
}

}  // namespace
