// SPDX-License-Identifier: GPL-3.0-or-later
// The three cases of the virtual start point, each on a triangle whose numbers are found by hand.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <virtual_start.h>

#include <support/mesh_types.h>
#include <support/naive_geodesics.h>
#include <vcg_core/geodesic_distance.h>

namespace {

using namespace test_support;
using Frame = vcg_core::detail::TriangleFrame<double>;

/// The frame of the triangle (0, 0), (edge, 0), (x, y), seen from the last vertex.
Frame frame(double edge, double x, double y) { return {edge, x, y, std::hypot(x, y), std::hypot(x - edge, y)}; }

double apex_distance(const Frame& triangle, double d_1, double d_2) {
  return vcg_core::detail::distance_by_virtual_start(triangle, d_1, d_2);
}

/// Distance of (x, y) from (s_x, s_y) over the mesh of two triangles on both sides of the edge (0, 0) to (edge, 0).
double across_edge(double s_x, double s_y, double edge, double x, double y) {
  DoubleMesh mesh;
  fill(mesh, {{{s_x, s_y, 0}, {0, 0, 0}, {edge, 0, 0}, {x, y, 0}}, {{0, 2, 1}, {1, 2, 3}}});
  return vcg_core::geodesic_distances(mesh, 0)[3];
}

// Figure 3. Start (1, -1), apex (1, 2): straight up through the middle of the edge from (0, 0) to (2, 0): 3.
TEST(VirtualStart, StraightThroughTheEdge) {
  EXPECT_DOUBLE_EQ(apex_distance(frame(2, 1, 2), std::sqrt(2), std::sqrt(2)), 3);
  EXPECT_DOUBLE_EQ(across_edge(1, -1, 2, 1, 2), 3);
}

// The same off the middle. Start (0, -3), apex (4, 0) + (0, 1) = (16/3, 1): the slope is 3/4, so the line meets the
// edge from (0, 0) to (5, 0) at x = 4, and the distance is 5 for the run of 4 to the edge and 5/3 for that of 4/3
// behind it.
TEST(VirtualStart, StraightThroughTheEdgeAtAnAngle) {
  EXPECT_NEAR(apex_distance(frame(5, 16.0 / 3, 1), 3, std::sqrt(34)), 20.0 / 3, 1e-15);
  EXPECT_NEAR(across_edge(0, -3, 5, 16.0 / 3, 1), 20.0 / 3, 1e-15);
}

// Figure 4a. Start (-4, -3), apex (3, 4): the line has slope 1 and meets y = 0 at x = -1, left of the edge from (0, 0)
// to (4, 0). The way around (0, 0) is 5 + 5.
TEST(VirtualStart, AroundTheFirstVertex) {
  EXPECT_DOUBLE_EQ(apex_distance(frame(4, 3, 4), 5, std::sqrt(73)), 10);
  EXPECT_DOUBLE_EQ(across_edge(-4, -3, 4, 3, 4), 10);
}

// Figure 4b, the mirror image. Start (8, -3), apex (1, 4): the line meets y = 0 at x = 5, right of (4, 0): 5 + 5.
TEST(VirtualStart, AroundTheSecondVertex) {
  EXPECT_DOUBLE_EQ(apex_distance(frame(4, 1, 4), std::sqrt(73), 5), 10);
  EXPECT_DOUBLE_EQ(across_edge(8, -3, 4, 1, 4), 10);
}

// Novotni's single case would say |v_i v_s|: shorter than any way over the triangles.
TEST(VirtualStart, NeverShorterThanTheStraightLineAllows) {
  EXPECT_GT(apex_distance(frame(4, 3, 4), 5, std::sqrt(73)), std::hypot(7, 7));
}

// Between the cases the rule is continuous: the line through an end of the edge is the way around it.
TEST(VirtualStart, CasesMeetAtTheEndsOfTheEdge) {
  const double through_end = apex_distance(frame(4, 3, 3), std::sqrt(2), std::hypot(5, 1));  // from (-1, -1)
  EXPECT_NEAR(through_end, std::sqrt(2) + std::sqrt(18), 1e-15);
}

// The start is one of the two vertices: the circle of radius 0.
TEST(VirtualStart, StartAtAVertex) {
  EXPECT_DOUBLE_EQ(apex_distance(frame(2, 3, 4), 0, 2), 5);
  EXPECT_DOUBLE_EQ(apex_distance(frame(2, 3, 4), 2, 0), std::sqrt(17));
}

// |d_1 - d_2| > |v_1 v_2|: the circles do not meet, and only the ways around are left.
TEST(VirtualStart, CirclesThatDoNotMeet) {
  EXPECT_DOUBLE_EQ(apex_distance(frame(1, 0, 1), 1, 5), 2);
  EXPECT_DOUBLE_EQ(apex_distance(frame(1, 1, 1), 5, 1), 2);
}

// The start lies on the edge, a third along it: the circles touch there, and rounding must not tear them apart.
TEST(VirtualStart, CirclesThatTouch) {
  for (const double edge : {0.3, 1.0, 7.0 / 3, std::sqrt(8)})
    for (const double part : {0.1, 1.0 / 3, 0.5, 0.7}) {
      const double d_1 = edge * part;
      EXPECT_NEAR(apex_distance(frame(edge, d_1, 2), d_1, edge - d_1), 2, 1e-7);
      EXPECT_NEAR(apex_distance(frame(edge, d_1, 2), d_1 * (1 - 1e-15), edge - d_1), 2, 1e-7);
    }
}

// d_1 + d_2 < |v_1 v_2|: they do not meet either.
TEST(VirtualStart, CirclesTooSmallToMeet) { EXPECT_DOUBLE_EQ(apex_distance(frame(4, 1, 1), 1, 1), 1 + std::sqrt(2)); }

TEST(VirtualStart, TriangleWithoutArea) {
  EXPECT_DOUBLE_EQ(apex_distance(frame(0, 3, 4), 1, 2), 6);  // v_1 = v_2
  EXPECT_DOUBLE_EQ(apex_distance(frame(4, 4, 0), 3, 5), 5);  // the apex at v_2
  EXPECT_DOUBLE_EQ(apex_distance(frame(4, 6, 0), 3, 5), 7);  // beyond v_2: around it
  EXPECT_DOUBLE_EQ(apex_distance(frame(8, 4, 0), 5, 5), 3);  // on the edge: the start is 3 below
  EXPECT_DOUBLE_EQ(apex_distance(frame(0, 0, 0), 1, 2), 1);  // all in one place
}

// v_2, v_1 and the apex follow each other on a line from the start, which is on it as well: 6 + 3, and not 6 - 3.
TEST(VirtualStart, AllOnOneLine) {
  EXPECT_DOUBLE_EQ(apex_distance(frame(3, -3, 0), 6, 9), 9);
  EXPECT_DOUBLE_EQ(apex_distance(frame(3, -3, 0), 9, 6), 12);
  EXPECT_DOUBLE_EQ(apex_distance(frame(3, 6, 0), 9, 6), 9);
  EXPECT_DOUBLE_EQ(apex_distance(frame(3, 2, 0), 6, 9), 8);
}

TEST(VirtualStart, ADistanceNotYetKnownLeavesTheOtherWay) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(apex_distance(frame(4, 0, 3), 1, infinity), 4);
}

// The library's formula and the reference's drawing in coordinates are two ways to the same number.
TEST(VirtualStart, AgreesWithTheReferenceOnManyTriangles) {
  for (double edge : {0.5, 1.0, 3.0})
    for (double x = -2; x <= 4; x += 0.37)
      for (double y = 0.05; y <= 3; y += 0.31)
        for (double s_x = -3; s_x <= 5; s_x += 0.41)
          for (double s_y = -3; s_y <= 0; s_y += 0.29) {
            const double d_1 = std::hypot(s_x, s_y);
            const double d_2 = std::hypot(s_x - edge, s_y);
            ASSERT_NEAR(apex_distance(frame(edge, x, y), d_1, d_2),
                        naive_virtual_start(Point(x, y, 0), Point(0, 0, 0), d_1, Point(edge, 0, 0), d_2), 1e-7)
                << edge << " " << x << " " << y << " " << s_x << " " << s_y;
          }
}

}  // namespace
