// SPDX-License-Identifier: GPL-3.0-or-later
// Single-source distances: the paper's figure 5, random planes, and what a caller meets at the edges of the contract.

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <mesh_tools/random.h>
#include <mesh_tools/shapes.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/naive_geodesics.h>
#include <support/progress_log.h>
#include <vcg_core/geodesic_distance.h>

namespace {

using namespace test_support;
using vcg_core::geodesic_distances;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where long double is no wider than double, only the bounds of the contract hold.
constexpr bool wide_long_double = std::numeric_limits<long double>::digits >= 64;

struct Errors {
  double largest = 0;
  double mean_square = 0;
};

/// Errors on a plane, where the geodesic distance is the Euclidean one.
Errors errors_on_plane(const mesh_tools::Mesh& mesh, std::size_t source) {
  const std::vector<double> distance = geodesic_distances(mesh, source);
  Errors errors;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const auto p = mesh.vert[v].cP() - mesh.vert[source].cP();
    const long double exact = std::hypot(static_cast<long double>(p[0]), static_cast<long double>(p[1]));
    const auto error = static_cast<double>(std::abs(distance[v] - exact));
    errors.largest = std::max(errors.largest, error);
    errors.mean_square += error * error / static_cast<double>(distance.size());
  }
  return errors;
}

Errors worst_on_plane(const mesh_tools::Mesh& mesh, const std::vector<std::size_t>& sources) {
  Errors worst;
  for (const std::size_t source : sources) {
    const Errors errors = errors_on_plane(mesh, source);
    worst.largest = std::max(worst.largest, errors.largest);
    worst.mean_square = std::max(worst.mean_square, errors.mean_square);
  }
  return worst;
}

std::vector<std::size_t> corners(const mesh_tools::Mesh& mesh) {
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    const auto& p = mesh.vert[v].cP();
    if ((p[0] == 0 || p[0] == 1) && (p[1] == 0 || p[1] == 1)) result.push_back(v);
  }
  return result;
}

std::vector<std::size_t> random_vertices(const mesh_tools::Mesh& mesh, int count) {
  mesh_tools::Random random(5);
  std::vector<std::size_t> result;
  for (int k = 0; k < count; ++k)
    result.push_back(static_cast<std::size_t>(random.uniform() * static_cast<double>(mesh.vert.size())));
  return result;
}

class Figure5 : public testing::TestWithParam<std::string> {};

// The paper: "the maximum error is 10^-15, the root mean square error is 10^-31", which is the mean squared error.
TEST_P(Figure5, FromTheCorner) {
  const mesh_tools::Mesh mesh = mesh_tools::make_shape(GetParam(), 10000);
  ASSERT_EQ(mesh.vert.size(), 10000u);
  ASSERT_EQ(corners(mesh).size(), 4u);
  const Errors errors = errors_on_plane(mesh, corners(mesh)[0]);
  EXPECT_LE(errors.largest, 1e-15);
  EXPECT_LE(errors.mean_square, 1e-31);
}

TEST_P(Figure5, FromAllCornersAndFiftyVertices) {
  const mesh_tools::Mesh mesh = mesh_tools::make_shape(GetParam(), 10000);
  std::vector<std::size_t> sources = corners(mesh);
  for (const std::size_t v : random_vertices(mesh, 50)) sources.push_back(v);
  const Errors worst = worst_on_plane(mesh, sources);
  // The contract, and what arithmetic in 64 binary digits gives: half a unit in the last place of a double, where
  // distances are above 1, is 1.1e-16.
  EXPECT_LE(worst.largest, wide_long_double ? 2.3e-16 : 3e-15);
  EXPECT_LE(worst.mean_square, wide_long_double ? 5e-33 : 7e-31);
  RecordProperty("largest", std::to_string(worst.largest * 1e16) + "e-16");
  RecordProperty("mean_square", std::to_string(worst.mean_square * 1e33) + "e-33");
}

INSTANTIATE_TEST_SUITE_P(Diagonals, Figure5,
                         testing::Values("plane_slash", "plane_backslash", "plane_alternating",
                                         "plane_random_diagonals"),
                         [](const auto& shape) { return shape.param; });

TEST(GeodesicDistance, OnARandomDelaunayPlane) {
  const mesh_tools::Mesh mesh = mesh_tools::make_shape("plane_delaunay", 10000);
  EXPECT_NEAR(static_cast<double>(mesh.vert.size()), 10000, 500);
  const Errors worst = worst_on_plane(mesh, random_vertices(mesh, 50));
  EXPECT_LE(worst.largest, wide_long_double ? 1e-15 : 5e-14);
  RecordProperty("largest", std::to_string(worst.largest * 1e16) + "e-16");
}

TEST(GeodesicDistance, AgreesWithTheSweepingReferenceOnACurvedMesh) {
  const FlatMesh shape = potato(3);
  DoubleMesh mesh;
  fill(mesh, shape);
  for (const std::size_t source : {0u, 100u, 641u}) {
    const std::vector<double> distance = geodesic_distances(mesh, source);
    const std::vector<double> expected = naive_geodesics(shape, source, 1e-14);
    for (std::size_t v = 0; v < distance.size(); ++v) ASSERT_NEAR(distance[v], expected[v], 1e-10) << v;
  }
}

TEST(GeodesicDistance, OfTheSourceIsZeroAndOfOthersPositive) {
  DoubleMesh mesh;
  fill(mesh, potato(2));
  const std::vector<double> distance = geodesic_distances(mesh, 17);
  for (std::size_t v = 0; v < distance.size(); ++v) EXPECT_EQ(distance[v] > 0, v != 17) << v;
  EXPECT_EQ(distance[17], 0);
}

TEST(GeodesicDistance, IsInfiniteWhereNoPathLeads) {
  FlatMesh two_parts = octahedron();
  append(two_parts, transformed(octahedron(), [](const Point& p) { return p + Point(5, 0, 0); }));
  two_parts.points.emplace_back(9, 9, 9);  // isolated
  DoubleMesh mesh;
  fill(mesh, two_parts);
  const std::vector<double> distance = geodesic_distances(mesh, 0);
  ASSERT_EQ(distance.size(), 13u);
  for (std::size_t v = 0; v < 6; ++v) EXPECT_TRUE(std::isfinite(distance[v])) << v;
  for (std::size_t v = 6; v < 13; ++v) EXPECT_EQ(distance[v], infinity) << v;
}

TEST(GeodesicDistance, FromAnIsolatedVertexReachesNothingElse) {
  FlatMesh shape = octahedron();
  shape.points.emplace_back(9, 9, 9);
  DoubleMesh mesh;
  fill(mesh, shape);
  const std::vector<double> distance = geodesic_distances(mesh, 6);
  for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(distance[v], infinity);
  EXPECT_EQ(distance[6], 0);
}

// A vertex that touches the surface in one point only, or faces joined by a vertex alone: a path may pass there.
TEST(GeodesicDistance, PassesThroughAVertexThatJoinsTwoFans) {
  DoubleMesh mesh;
  fill(mesh, {{{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 2}, {0, 4, 3}}});
  EXPECT_DOUBLE_EQ(geodesic_distances(mesh, 1)[3], 2 * std::sqrt(2));
}

TEST(GeodesicDistance, OfDeletedVerticesIsInfiniteAndTheyBlockTheWay) {
  const FlatMesh shape = grid(5);
  DoubleMesh mesh;
  fill(mesh, shape);
  for (std::size_t y = 0; y < 5; ++y) vcg::tri::Allocator<DoubleMesh>::DeleteVertex(mesh, mesh.vert[5 * y + 2]);
  for (auto& face : mesh.face)
    if (face.V(0)->IsD() || face.V(1)->IsD() || face.V(2)->IsD())
      vcg::tri::Allocator<DoubleMesh>::DeleteFace(mesh, face);
  const std::vector<double> distance = geodesic_distances(mesh, 0);
  ASSERT_EQ(distance.size(), 25u);
  for (std::size_t v = 0; v < 25; ++v) EXPECT_EQ(std::isfinite(distance[v]), v % 5 < 2) << v;
  EXPECT_DOUBLE_EQ(distance[21], std::hypot(0.25, 1));
}

TEST(GeodesicDistance, OfAConstMeshInSinglePrecision) {
  FloatMesh mesh;
  fill(mesh, grid(9));
  const FloatMesh& only_read = mesh;
  EXPECT_DOUBLE_EQ(geodesic_distances(only_read, 0)[80], std::sqrt(2));
}

TEST(GeodesicDistance, AtAnyScaleAndPlace) {
  const FlatMesh shape = potato(2);
  DoubleMesh unit;
  fill(unit, shape);
  const std::vector<double> expected = geodesic_distances(unit, 3);
  for (const double scale : {1e-12, 1e-6, 1e6, 1e12, 1e-150, 1e150}) {
    DoubleMesh mesh;
    fill(mesh, transformed(shape, [&](const Point& p) { return p * scale; }));
    const std::vector<double> distance = geodesic_distances(mesh, 3);
    for (std::size_t v = 0; v < distance.size(); ++v)
      ASSERT_NEAR(distance[v] / scale, expected[v], 1e-12) << v << " at scale " << scale;
  }
}

TEST(GeodesicDistance, RefusesASourceThatTheMeshDoesNotHave) {
  DoubleMesh mesh;
  fill(mesh, grid(3));
  vcg::tri::Allocator<DoubleMesh>::AddVertices(mesh, 1);
  vcg::tri::Allocator<DoubleMesh>::DeleteVertex(mesh, mesh.vert[9]);
  for (const std::size_t bad : {std::size_t(9), std::size_t(10), std::numeric_limits<std::size_t>::max()}) {
    try {
      geodesic_distances(mesh, bad);
      ADD_FAILURE() << "no error for vertex " << bad;
    } catch (const vcg_core::InvalidParameter& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(std::to_string(bad)), std::string::npos) << message;
    }
  }
}

TEST(GeodesicDistance, RefusesMeshesAsSmoothingDoes) {
  DoubleMesh empty;
  EXPECT_THROW(geodesic_distances(empty, 0), vcg_core::InvalidMesh);
  DoubleMesh mesh;
  fill(mesh, grid(3));
  mesh.vert[4].P()[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(geodesic_distances(mesh, 0), vcg_core::InvalidMesh);
}

TEST(GeodesicDistance, CanBeCancelled) {
  DoubleMesh mesh;
  fill(mesh, grid(30));
  EXPECT_THROW(geodesic_distances(mesh, 0, [](double, const char*) { return false; }), vcg_core::Cancelled);
  EXPECT_THROW(geodesic_distances(mesh, 0, [](double fraction, const char*) { return fraction < 1; }),
               vcg_core::Cancelled);
  ProgressLog log;
  geodesic_distances(mesh, 0, log.callable());
  EXPECT_EQ(log.calls().front().fraction, 0);
  EXPECT_EQ(log.calls().back().fraction, 1);
}

}  // namespace
