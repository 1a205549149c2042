// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of a result, on moves made by hand and on real ones against a naive recount.

#include <result_check.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <job.h>
#include <mesh/read_mesh.h>
#include <power_of_two.h>
#include <support/bad_meshes.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/noisy_shapes.h>
#include <support/result_census.h>
#include <support/smoothed_by.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;
using namespace vcg_core::detail;
using vcg_core::Method;
using vcg_core::SmoothingReport;

/// The report of a mesh whose vertices another hand moved.
template <class Mesh = DoubleMesh>
SmoothingReport report_of_move(const FlatMesh& before, const std::function<Point(std::size_t, const Point&)>& move) {
  Mesh mesh;
  fill(mesh, before);
  const vcg_core::Progress no_progress;
  Job job(no_progress, 2);
  const MeshArrays arrays = read_mesh(vcg_core::view_of(mesh), job);
  Array<Vec3> position = arrays.position;
  for (std::size_t v = 0; v < position.size(); ++v) {
    const Point to = move(arrays.host_vertex[v], before.points[arrays.host_vertex[v]]);
    position[v] = PowerOfTwo(arrays.exponent) * Vec3(to[0], to[1], to[2]);
  }
  SmoothingReport report;
  check_result(arrays, position, report, job);
  return report;
}

/// One vertex moved to a place.
SmoothingReport report_of_one_moved(const FlatMesh& before, std::size_t vertex, const Point& to) {
  return report_of_move(before, [&](std::size_t v, const Point& p) { return v == vertex ? to : p; });
}

SmoothingReport report_of_nothing_moved(const FlatMesh& mesh) {
  return report_of_move(mesh, [](std::size_t, const Point& p) { return p; });
}

FlatMesh square() { return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}}; }

TEST(ResultCheck, CountsFlippedFaces) {
  EXPECT_EQ(report_of_nothing_moved(square()).flipped_faces, 0u);
  EXPECT_EQ(report_of_one_moved(square(), 1, {0.2, 0.8, 0}).flipped_faces, 1u) << "folded over the diagonal";
  EXPECT_EQ(report_of_one_moved(square(), 0, {2, 2, 0}).flipped_faces, 2u);
  EXPECT_EQ(report_of_one_moved(square(), 1, {0.5, 0.5, 1}).flipped_faces, 0u) << "turned by 90 degrees";
  EXPECT_EQ(report_of_one_moved(square(), 1, {0.5 - 1e-6, 0.5 + 1e-6, 1}).flipped_faces, 1u);
  const auto mirrored = report_of_move(grid(5), [](std::size_t, const Point& p) { return Point(-p[0], p[1], p[2]); });
  EXPECT_EQ(mirrored.flipped_faces, 32u);
  EXPECT_EQ(mirrored.faces, 32u);
}

TEST(ResultCheck, FacesWithoutAreaAreNotFlipped) {
  EXPECT_EQ(report_of_one_moved(square(), 1, {0.5, 0.5, 0}).flipped_faces, 0u) << "without area afterwards";
  FlatMesh mesh = square();
  mesh.points[1] = {0.5, 0.5, 0};
  EXPECT_EQ(report_of_one_moved(mesh, 1, {0.2, 0.8, 0}).flipped_faces, 0u) << "without area before";
  // Less than 1e-12 high, yet not nothing: its normal is what rounding makes of it.
  const double little = 1e-14;
  EXPECT_EQ(report_of_one_moved(square(), 1, {0.5 - little, 0.5 + little, 0}).flipped_faces, 0u);
  mesh.points[1] = {0.5 + little, 0.5 - little, 0};
  EXPECT_EQ(report_of_one_moved(mesh, 1, {0.2, 0.8, 0}).flipped_faces, 0u);
  mesh.points[1] = {0.5 + 1e-10, 0.5 - 1e-10, 0};
  EXPECT_EQ(report_of_one_moved(mesh, 1, {0.2, 0.8, 0}).flipped_faces, 1u);
  mesh = square();
  mesh.faces.push_back({0, 0, 2});
  EXPECT_EQ(report_of_one_moved(mesh, 0, {2, 2, 0}).flipped_faces, 2u) << "the third has a repeated vertex";
}

// All edges of the octahedron are |e| = sqrt 2 long.
TEST(ResultCheck, CountsVerticesThatMovedFar) {
  const double e = std::sqrt(2);
  const auto moved_by = [](double length) {
    FlatMesh mesh = octahedron();
    return report_of_one_moved(mesh, 0, mesh.points[0] + Point(0, length, 0));
  };
  for (const double length : {0.5 * e, 0.999 * e}) {
    EXPECT_EQ(moved_by(length).beyond_ring_vertices, 0u);
    EXPECT_EQ(moved_by(length).far_moved_vertices, 0u);
  }
  for (const double length : {1.001 * e, 1.999 * e}) {
    EXPECT_EQ(moved_by(length).beyond_ring_vertices, 1u);
    EXPECT_EQ(moved_by(length).far_moved_vertices, 0u);
  }
  EXPECT_EQ(moved_by(2.001 * e).far_moved_vertices, 1u);
  EXPECT_EQ(moved_by(2.001 * e).beyond_ring_vertices, 1u);
}

// A vertex on one long edge may move as far as that, however short the others are.
TEST(ResultCheck, TheLongestEdgeOfTheRingCounts) {
  const FlatMesh kite = {{{0, 0, 0}, {8, 0, 0}, {0, 0.1, 0}, {0, -0.1, 0}}, {{0, 1, 2}, {0, 3, 1}}};
  EXPECT_EQ(report_of_one_moved(kite, 0, {0, 0, 7.9}).beyond_ring_vertices, 0u);
  EXPECT_EQ(report_of_one_moved(kite, 0, {0, 0, 8.1}).beyond_ring_vertices, 1u);
  for (const Triangle& face : {Triangle{0, 1, 2}, Triangle{0, 2, 1}}) {
    const FlatMesh alone = {{{0, 0, 0}, {8, 0, 0}, {0, 0.1, 0}}, {face}};
    EXPECT_EQ(report_of_one_moved(alone, 0, {0, 0, 7.9}).beyond_ring_vertices, 0u);
    EXPECT_EQ(report_of_one_moved(alone, 0, {0, 0, 8.1}).beyond_ring_vertices, 1u);
  }
}

TEST(ResultCheck, TellsClosedMeshes) {
  EXPECT_TRUE(report_of_nothing_moved(cube()).closed);
  EXPECT_TRUE(report_of_nothing_moved(icosphere(3)).closed);
  EXPECT_FALSE(report_of_nothing_moved(grid(4)).closed);

  FlatMesh with_isolated = cube();
  with_isolated.points.emplace_back(5, 5, 5);
  EXPECT_TRUE(report_of_nothing_moved(with_isolated).closed);

  FlatMesh one_turned = cube();
  std::swap(one_turned.faces[5][0], one_turned.faces[5][1]);
  EXPECT_FALSE(report_of_nothing_moved(one_turned).closed);
  FlatMesh all_turned = cube();
  for (Triangle& face : all_turned.faces) std::swap(face[0], face[1]);
  EXPECT_TRUE(report_of_nothing_moved(all_turned).closed);

  EXPECT_FALSE(report_of_nothing_moved(bad_mesh<double>("klein_bottle").mesh).closed);
  FlatMesh doubled = cube();
  for (const Triangle& face : cube().faces) doubled.faces.push_back(face);
  EXPECT_FALSE(report_of_nothing_moved(doubled).closed) << "four faces at each edge";
}

TEST(ResultCheck, TellsTheSpacingOfTheCoordinates) {
  const auto spacing = [](const SmoothingReport& report) { return report.coordinate_spacing; };
  const FlatMesh far_away = transformed(cube(), [](const Point& p) { return p + Point(1e6, 0, 0); });
  const auto stay = [](std::size_t, const Point& p) { return p; };
  // 2^19 < 1e6 < 2^20, and a float has 23 bits behind the first one.
  EXPECT_EQ(spacing(report_of_move<FloatMesh>(far_away, stay)), std::ldexp(1.0, 19 - 23));
  EXPECT_EQ(spacing(report_of_move<DoubleMesh>(far_away, stay)), std::ldexp(1.0, 19 - 52));
  EXPECT_EQ(spacing(report_of_move<FloatMesh>(cube(), stay)), std::ldexp(1.0, -1 - 23));
  FlatMesh with_stray = cube();
  with_stray.points.emplace_back(1e30, 0, 0);
  EXPECT_EQ(spacing(report_of_move<DoubleMesh>(with_stray, stay)), std::ldexp(1.0, -1 - 52));
}

/// What is counted is what is stored: far from the origin rounding moves vertices as much as the filter does.
template <class Mesh>
void expect_counts_of_what_is_stored(Method method, double offset) {
  Mesh mesh;
  fill(mesh,
       transformed(noisy_shape("cad_part", 1500, 0.4), [&](const Point& p) { return p * 16 + Point(offset, 0, 0); }));
  const FlatMesh before = flat(mesh);
  vcg_core::SmoothingParameters parameters = vcg_core::method_info(method).defaults;
  const SmoothingReport report = vcg_core::smooth(mesh, method, parameters);
  const ResultCensus census = take_census(before, flat(mesh));
  SCOPED_TRACE(std::to_string(offset) + (sizeof(typename Mesh::ScalarType) == 4 ? ", float" : ", double"));
  EXPECT_EQ(report.flipped_faces, census.flipped_faces);
  EXPECT_EQ(report.far_moved_vertices, census.far_moved_vertices);
  EXPECT_EQ(report.beyond_ring_vertices, census.beyond_ring_vertices);
  EXPECT_EQ(report.faces, before.faces.size());
  EXPECT_TRUE(report.closed);
}

TEST(ResultCheck, CountsWhatIsStored) {
  for (const vcg_core::MethodInfo& info : vcg_core::methods()) {
    SCOPED_TRACE(info.name);
    for (const double offset : {0.0, 3e6}) {
      expect_counts_of_what_is_stored<DoubleMesh>(info.method, offset);
      expect_counts_of_what_is_stored<FloatMesh>(info.method, offset);
    }
  }
}

// A float has fewer digits below 2^-126: of the caller's numbers, not of those that the mesh is scaled to.
TEST(ResultCheck, RoundsAtTheScaleOfTheCaller) {
  for (const int exponent : {-148, -130, 0, 100, 126}) {
    FlatMesh mesh = square();
    for (Point& p : mesh.points) p *= std::ldexp(1.0, exponent);
    mesh.points[3][2] = 0x1p-140;
    FloatMesh host;
    fill(host, mesh);
    const vcg_core::Progress no_progress;
    Job job(no_progress, 1);
    const MeshArrays arrays = read_mesh(vcg_core::view_of(host), job);
    Array<Vec3> position = arrays.position;
    round_as_stored(arrays, position, job);
    EXPECT_EQ(position, arrays.position) << exponent << ": what is stored already stays";
    const PowerOfTwo to_arrays(arrays.exponent);
    const PowerOfTwo to_host(-arrays.exponent);
    for (Vec3& p : position) p *= 1.1;
    const Array<Vec3> wanted = position;
    round_as_stored(arrays, position, job);
    for (std::size_t v = 0; v < position.size(); ++v)
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(position[v][k], to_arrays * static_cast<double>(static_cast<float>(to_host * wanted[v][k])))
            << exponent;
    position[0][0] = to_arrays * 1e39;
    round_as_stored(arrays, position, job);
    EXPECT_EQ(position[0], arrays.position[0]) << "no float is as large: the vertex stays";
  }
}

// So large that several threads' counts are added up.
TEST(ResultCheck, CountsOnALargeMesh) {
  const FlatMesh before = noisy_shape("cad_part", 30000, 1.5);
  const SmoothedBy result = smoothed_by(Method::laplacian, before);
  const ResultCensus census = take_census(before, result.mesh);
  EXPECT_GT(census.flipped_faces, 500u);
  EXPECT_GT(census.far_moved_vertices, 100u);
  EXPECT_GT(census.beyond_ring_vertices, 100u);
  EXPECT_EQ(result.report.flipped_faces, census.flipped_faces);
  EXPECT_EQ(result.report.far_moved_vertices, census.far_moved_vertices);
  EXPECT_EQ(result.report.beyond_ring_vertices, census.beyond_ring_vertices);
}

}  // namespace
