// SPDX-License-Identifier: GPL-3.0-or-later
// Every field of the report on meshes small enough to do by hand.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/noisy_shapes.h>
#include <support/smoothed_by.h>
#include <support/smoothing_path.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;

SmoothingReport report_of(const FlatMesh& shape, const SmoothingParameters& parameters = {}) {
  DoubleMesh mesh;
  fill(mesh, shape);
  return vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
}

// The unit cube. Its 12 edges and 6 diagonals give |e| = (12 + 6 sqrt 2) / 18. All vertices lie within 4 |e| of each
// other. Normals are along the diagonals of space, n_j = s_j / sqrt 3 with s_j the signs of v_j = s_j / 2, so of a
// vertex that differs from v_i in k signs the distance is sqrt k, the height n_j.(v_i - v_j) = -k / sqrt 3, and
// 1 - n_i.n_j = 2k / 3. There are 1, 3, 3 and 1 of them with k = 0, 1, 2, 3. By symmetry all vertices move alike, along
// their diagonals, and the cube stays a cube.
TEST(SmoothingReport, OfTheUnitCube) {
  const double e = (12 + 6 * std::sqrt(2)) / 18;
  double sum = 0;
  double sum_of_weights = 0;
  const double count[] = {1, 3, 3, 1};
  for (int k = 0; k <= 3; ++k) {
    const double height = -k / std::sqrt(3);
    const double w_c = std::exp(-k / (2 * 2 * e * 2 * e));
    const double w_s = std::exp(-height * height / (2 * e * e));
    const double w_n = std::exp(-(2 * k / 3.0) * (2 * k / 3.0) / (2 * 0.3 * 0.3));
    sum += count[k] * height * w_c * w_s * w_n;
    sum_of_weights += count[k] * w_c * w_s * w_n;
  }
  const double outwards = -sum / sum_of_weights;
  const double side_after = 1 + 2 * outwards / std::sqrt(3);
  ASSERT_GT(outwards, 0.01);

  for (const SmoothingPath& path : smoothing_paths()) {
    const SmoothingReport report = report_of(cube(), path.parameters);
    const double tolerance = path.position_tolerance;
    EXPECT_NEAR(report.average_edge_length, e, 1e-15);
    EXPECT_NEAR(report.sigma_c_length, 2 * e, 1e-15);
    EXPECT_NEAR(report.sigma_s_length, e, 1e-15);
    EXPECT_NEAR(report.rho_length, 4 * e, 1e-15);
    EXPECT_EQ(report.vertices, 8u);
    EXPECT_EQ(report.moved_vertices, 8u);
    EXPECT_EQ(report.fixed_vertices, 0u);
    EXPECT_EQ(report.skipped_vertices.total(), 0u);
    EXPECT_NEAR(report.max_displacement, outwards, tolerance);
    EXPECT_NEAR(report.rms_displacement, outwards, tolerance);
    EXPECT_NEAR(report.volume_before, 1, 1e-15);
    EXPECT_NEAR(report.volume_after, std::pow(side_after, 3), 3 * tolerance);
    EXPECT_EQ(report.border_vertices, 0u);
    EXPECT_EQ(report.non_manifold_vertices, 0u);
    EXPECT_EQ(report.coincident_vertices, 0u);
    EXPECT_EQ(report.degenerate_faces, 0u);
    EXPECT_EQ(report.faces, 12u);
    EXPECT_EQ(report.flipped_faces, 0u);
    EXPECT_EQ(report.far_moved_vertices, 0u);
    EXPECT_EQ(report.beyond_ring_vertices, 0u);
    EXPECT_EQ(report.bounded_vertices, 0u);
    EXPECT_FALSE(report.self_intersections.has_value());
    EXPECT_TRUE(report.closed);
    // A volume of 1.377: the cube is as coarse as can be.
    ASSERT_EQ(report.warnings().size(), 1u);
    EXPECT_EQ(report.warnings()[0].find("the enclosed volume changed from 1 to 1.38, by 37.7 %"), 0u)
        << report.warnings()[0];
    EXPECT_NE(report.warnings()[0].find("use the guided filter"), std::string::npos);
  }
}

// Lengths and volumes are in the mesh's own unit, parameters in |e|.
TEST(SmoothingReport, ScalesWithTheMesh) {
  SmoothingParameters parameters;
  parameters.sigma_c = 3;
  parameters.sigma_s = 0.5;
  parameters.rho = 1.5;
  const SmoothingReport one = report_of(potato(1), parameters);
  const SmoothingReport ten = report_of(transformed(potato(1), [](const Point& p) { return p * 1024; }), parameters);
  EXPECT_DOUBLE_EQ(one.sigma_c_length, 3 * one.average_edge_length);
  EXPECT_DOUBLE_EQ(one.sigma_s_length, 0.5 * one.average_edge_length);
  EXPECT_DOUBLE_EQ(one.rho_length, 4.5 * one.average_edge_length);
  EXPECT_EQ(ten.average_edge_length, 1024 * one.average_edge_length);
  EXPECT_EQ(ten.max_displacement, 1024 * one.max_displacement);
  EXPECT_EQ(ten.rms_displacement, 1024 * one.rms_displacement);
  EXPECT_EQ(ten.volume_before, std::ldexp(one.volume_before, 30));
  EXPECT_EQ(ten.volume_after, std::ldexp(one.volume_after, 30));
  EXPECT_LT(one.rms_displacement, one.max_displacement);
}

// A square of 3 x 3 vertices whose middle is raised: 8 border vertices stay, one moves, straight up or down.
TEST(SmoothingReport, OfASquareWithFixedBorder) {
  FlatMesh square = grid(3);
  square.points[4][2] = 0.25;
  const SmoothingReport report = report_of(square);
  EXPECT_EQ(report.vertices, 9u);
  EXPECT_EQ(report.border_vertices, 8u);
  EXPECT_EQ(report.fixed_vertices, 8u);
  EXPECT_EQ(report.moved_vertices, 1u);
  EXPECT_GT(report.max_displacement, 0.01);
  EXPECT_EQ(report.rms_displacement, report.max_displacement);
  // A tent over the unit square is a third of its base times its height; the cone from the box's centre, at half that
  // height, over the six faces around the tip (an area of 3/4 from above) and two flat ones tells the same.
  EXPECT_NEAR(report.volume_before - report.volume_after,
              (report.volume_before + 0.125 * (1.0 / 3)) / 0.25 * report.max_displacement, 1e-3);
}

TEST(SmoothingReport, CountsUnselectedVerticesAsFixed) {
  DoubleMesh mesh;
  fill(mesh, octahedron());
  mesh.vert[0].SetS();
  mesh.face[6].SetS();  // vertices 3, 1 and 5
  SmoothingParameters parameters;
  parameters.selected_only = true;
  const SmoothingReport report = vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
  EXPECT_EQ(report.moved_vertices, 4u);
  EXPECT_EQ(report.fixed_vertices, 2u);
}

TEST(SmoothingReport, OfNothingSelected) {
  SmoothingParameters parameters;
  parameters.selected_only = true;
  const SmoothingReport report = report_of(octahedron(), parameters);
  EXPECT_EQ(report.moved_vertices, 0u);
  EXPECT_EQ(report.fixed_vertices, 6u);
  EXPECT_EQ(report.max_displacement, 0);
  EXPECT_EQ(report.rms_displacement, 0);
  EXPECT_EQ(report.volume_before, report.volume_after);
}

TEST(SmoothingReport, CountsIsolatedVertices) {
  FlatMesh shape = octahedron();
  shape.points.emplace_back(3, 0, 0);
  shape.points.emplace_back(4, 0, 0);
  const SmoothingReport report = report_of(shape);
  EXPECT_EQ(report.vertices, 8u);
  EXPECT_EQ(report.moved_vertices, 6u);
  EXPECT_EQ(report.skipped_vertices.isolated, 2u);
  EXPECT_EQ(report.skipped_vertices.undefined_normal, 0u);
  EXPECT_EQ(report.skipped_vertices.total(), 2u);
  ASSERT_FALSE(report.warnings().empty());
  EXPECT_NE(report.warnings()[0].find("2 vertices belong to no face"), std::string::npos);
}

// A vertex is counted once: one that is held by the selection is not skipped as well.
TEST(SmoothingReport, FixedComesBeforeSkipped) {
  FlatMesh shape = octahedron();
  shape.points.emplace_back(3, 0, 0);
  SmoothingParameters parameters;
  parameters.selected_only = true;
  const SmoothingReport report = report_of(shape, parameters);
  EXPECT_EQ(report.fixed_vertices, 7u);
  EXPECT_EQ(report.skipped_vertices.total(), 0u);
}

// Two faces back to back: every edge has two faces, and every vertex normals that cancel.
TEST(SmoothingReport, CountsUndefinedNormals) {
  const SmoothingReport report = report_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  EXPECT_EQ(report.skipped_vertices.undefined_normal, 3u);
  EXPECT_EQ(report.moved_vertices, 0u);
  EXPECT_EQ(report.border_vertices, 0u);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_NE(report.warnings()[0].find("3 vertices have no defined normal"), std::string::npos);
}

// Three pages of a book, bound in the edge 0-1.
TEST(SmoothingReport, CountsNonManifoldVertices) {
  const SmoothingReport report =
      report_of({{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}});
  EXPECT_EQ(report.non_manifold_vertices, 2u);
  EXPECT_EQ(report.border_vertices, 5u);
}

// As read from STL: each face has vertices of its own. Four of the octahedron's faces meet in each vertex.
TEST(SmoothingReport, CountsCoincidentVertices) {
  const FlatMesh shape = octahedron();
  FlatMesh unmerged;
  for (const Triangle& f : shape.faces) {
    const std::size_t first = unmerged.points.size();
    for (const std::size_t v : f) unmerged.points.push_back(shape.points[v]);
    unmerged.faces.push_back({first, first + 1, first + 2});
  }
  unmerged.points.emplace_back(7, 7, 7);  // alone in its place, if not in any face
  const SmoothingReport report = report_of(unmerged);
  EXPECT_EQ(report.coincident_vertices, 24u);
  EXPECT_EQ(report.border_vertices, 0u);    // the octahedron is closed
  EXPECT_EQ(report.warnings().size(), 1u);  // about the one that belongs to no face
}

// The coordinate 0 has two signs and is one place.
TEST(SmoothingReport, NegativeZeroIsTheSamePlace) {
  const SmoothingReport report =
      report_of({{{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}});
  EXPECT_EQ(report.coincident_vertices, 2u);
}

TEST(SmoothingReport, CountsDegenerateFaces) {
  FlatMesh shape = grid(3);
  shape.faces.push_back({0, 0, 4});  // a repeated vertex
  shape.faces.push_back({0, 1, 2});  // three vertices on a line
  EXPECT_EQ(report_of(shape).degenerate_faces, 2u);
}

/// A report of a mesh of 1000 faces and |e| = 2 that has nothing to warn of.
SmoothingReport good_report() {
  SmoothingReport report;
  report.average_edge_length = 2;
  report.vertices = 502;
  report.faces = 1000;
  report.closed = true;
  report.volume_before = report.volume_after = 100;
  report.advice = "use something else";
  return report;
}

/// The only warning of a report; without one, or with several, what is wrong.
std::string only_warning(const SmoothingReport& report) {
  const std::vector<std::string> warnings = report.warnings();
  return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
}

TEST(SmoothingReportWarnings, AreNoneForAGoodResult) { EXPECT_TRUE(good_report().warnings().empty()); }

TEST(SmoothingReportWarnings, OfFlippedFacesAboveOnePercent) {
  SmoothingReport report = good_report();
  report.flipped_faces = 10;
  EXPECT_TRUE(report.warnings().empty());
  report.flipped_faces = 11;
  EXPECT_EQ(only_warning(report),
            "11 of 1000 faces (1.1 %) face the opposite way from before: the surface folds there, unless strong noise"
            " had turned them; use something else");
}

TEST(SmoothingReportWarnings, OfTheVolumeOfAClosedMeshAboveFivePercent) {
  SmoothingReport report = good_report();
  for (const double volume : {95.01, 104.99}) {
    report.volume_after = volume;
    EXPECT_TRUE(report.warnings().empty()) << volume;
  }
  for (const double volume : {-100.0, 94.9, 105.1, 300.0}) {
    report.volume_after = volume;
    EXPECT_EQ(only_warning(report).find("the enclosed volume changed from 100 to "), 0u) << volume;
    report.closed = false;
    EXPECT_TRUE(report.warnings().empty()) << volume;
    report.closed = true;
  }
  report.volume_after = 94;
  EXPECT_EQ(only_warning(report), "the enclosed volume changed from 100 to 94, by -6 %; use something else");
  // Inside out.
  report.volume_before = -100;
  report.volume_after = -94;
  EXPECT_EQ(only_warning(report), "the enclosed volume changed from -100 to -94, by 6 %; use something else");
  // What rounding makes of a flat shape.
  report.volume_before = 1e-12;
  report.volume_after = -3e-12;
  EXPECT_TRUE(report.warnings().empty());
  report.volume_before = 0;
  report.volume_after = 1;
  EXPECT_EQ(only_warning(report), "the enclosed volume changed from 0 to 1; use something else");
}

TEST(SmoothingReportWarnings, OfVerticesThatMovedFar) {
  SmoothingReport report = good_report();
  report.max_displacement = 7;
  report.far_moved_vertices = 1;
  EXPECT_EQ(only_warning(report),
            "1 vertex moved by more than twice the average edge length, the farthest by 3.5 times that length; use"
            " something else");
  report = good_report();
  report.beyond_ring_vertices = 3;
  EXPECT_EQ(only_warning(report), "3 vertices moved farther than the longest edge there; use something else");
}

TEST(SmoothingReportWarnings, OfSelfIntersections) {
  SmoothingReport report = good_report();
  report.self_intersections = 0;
  EXPECT_TRUE(report.warnings().empty());
  report.self_intersections = 6;
  EXPECT_EQ(only_warning(report), "6 faces of the result cut through other faces; use something else");
}

TEST(SmoothingReportWarnings, OfCoordinatesWithTooFewDigits) {
  SmoothingReport report = good_report();
  report.coordinate_spacing = 0.02;
  EXPECT_TRUE(report.warnings().empty());
  report.coordinate_spacing = 0.0625;
  EXPECT_EQ(only_warning(report),
            "the mesh lies so far from the origin that its coordinates are stored in steps of 0.0625, 3.12 % of the"
            " average edge length; move it to the origin before it is saved, or use double precision");
}

TEST(SmoothingReportWarnings, EndWithTheNotes) {
  SmoothingReport report = good_report();
  report.notes = {"first", "second"};
  report.beyond_ring_vertices = 1;
  ASSERT_EQ(report.warnings().size(), 3u);
  EXPECT_EQ(report.warnings()[1], "first");
  EXPECT_EQ(report.warnings()[2], "second");
}

// A float has steps of 1/16 at a million. In double precision, or at the origin, there is nothing to say.
TEST(SmoothingReportWarnings, OfAMeshFarFromTheOrigin) {
  const auto warned = [](auto& mesh, double offset) {
    fill(mesh, transformed(icosphere(3), [&](const Point& p) { return p * 4 + Point(offset, offset, 0); }));
    const SmoothingReport report =
        vcg_core::smooth(mesh, vcg_core::Method::guided, vcg_core::method_info(vcg_core::Method::guided).defaults);
    EXPECT_NEAR(report.average_edge_length, 0.6, 0.15);
    for (const std::string& sentence : report.warnings())
      if (sentence.find("far from the origin") != std::string::npos) return true;
    return false;
  };
  FloatMesh far_away, close_by;
  DoubleMesh in_double;
  EXPECT_TRUE(warned(far_away, 1e6));
  EXPECT_FALSE(warned(close_by, 0));
  EXPECT_FALSE(warned(in_double, 1e6));
}

TEST(SmoothingReportWarnings, AreNoneForANoisyPartByTheGuidedFilter) {
  const FlatMesh part = noisy_shape("cad_part", 4000);
  for (const auto& [method, shape] :
       {std::pair(vcg_core::Method::guided, part), std::pair(vcg_core::Method::paper, part)}) {
    const SmoothedBy result = smoothed_by(method, shape);
    EXPECT_GT(result.report.moved_vertices, 3000u);
    EXPECT_TRUE(result.report.warnings().empty()) << result.report.warnings()[0];
  }
}

// Each method says what to use in its place.
TEST(SmoothingReportWarnings, NameARemedyForEveryMethod) {
  for (const vcg_core::MethodInfo& info : vcg_core::methods()) {
    const std::string advice = smoothed_by(info.method, octahedron()).report.advice;
    EXPECT_EQ(advice.find("guided") != std::string::npos, info.method != vcg_core::Method::guided) << info.name;
    EXPECT_NE(advice.find("use "), std::string::npos) << info.name;
  }
}

}  // namespace
