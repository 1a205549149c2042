// Every field of the report on meshes small enough to do by hand.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/hand_made.h>
#include <support/mesh_types.h>
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
    EXPECT_TRUE(report.warnings().empty());
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
  ASSERT_EQ(report.warnings().size(), 1u);
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
  bool remedy_named = false;
  for (const std::string& warning : report.warnings())
    remedy_named |= warning.find("Merge Close Vertices") != std::string::npos && warning.find("24") == 0;
  EXPECT_TRUE(remedy_named);
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

}  // namespace
