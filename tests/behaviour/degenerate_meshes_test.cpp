// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as they come: for every kind of defect, counted, finite, and no worse around it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/naive_reference.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>
#include <vcg_core/geodesic_distance.h>

namespace {

using namespace test_support;
using vcg_core::SmoothingReport;

class DegenerateMeshes : public testing::TestWithParam<SmoothingPath> {
 protected:
  /// Smooths a copy and keeps its points in `result_`; sees to what holds for every mesh.
  SmoothingReport run(const FlatMesh& shape, int iterations = 3) {
    DoubleMesh mesh;
    fill(mesh, shape);
    vcg_core::SmoothingParameters parameters = GetParam().parameters;
    parameters.iterations = iterations;
    const SmoothingReport report = vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
    result_ = flat(mesh);
    EXPECT_TRUE(all_finite(result_));
    EXPECT_TRUE(std::isfinite(report.max_displacement) && std::isfinite(report.rms_displacement));
    EXPECT_TRUE(std::isfinite(report.volume_before) && std::isfinite(report.volume_after));
    if (iterations == 1) {  // a vertex that is skipped in the first pass may move in a later one
      EXPECT_LE(report.moved_vertices + report.fixed_vertices + report.skipped_vertices.total(), report.vertices);
    }
    for (const double d : vcg_core::geodesic_distances(mesh, 0)) EXPECT_FALSE(std::isnan(d));
    return report;
  }

  /// Compares one pass with the naive reference, which treats defects by the same decisions.
  void expect_as_reference(const FlatMesh& shape) {
    run(shape, 1);
    const FlatMesh expected = naive_smooth(shape, GetParam().parameters, 1);
    EXPECT_TRUE(same_smoothing(result_, expected, GetParam(), average_edge_length(shape)));
  }

  FlatMesh result_;
};

TEST_P(DegenerateMeshes, IsolatedVerticesStayAndCountForNothing) {
  const FlatMesh clean = potato(2);
  FlatMesh shape = clean;
  for (int k = 0; k < 5; ++k) shape.points.push_back(clean.points[0] * 1.01);
  const SmoothingReport report = run(shape, 1);
  EXPECT_EQ(report.skipped_vertices.isolated, 5u);
  for (std::size_t v = clean.points.size(); v < shape.points.size(); ++v) EXPECT_EQ(result_.points[v], shape.points[v]);
  result_.points.resize(clean.points.size());
  EXPECT_TRUE(same_smoothing(result_, smoothed(clean, GetParam().parameters), GetParam(), average_edge_length(clean)));
}

TEST_P(DegenerateMeshes, FacesWithRepeatedVerticesAreNoFaces) {
  const FlatMesh clean = potato(2);
  FlatMesh shape = clean;
  for (std::size_t k = 0; k < 20; ++k) shape.faces.push_back({k, k, k + 40});
  shape.faces.push_back({3, 3, 3});
  EXPECT_EQ(run(shape, 1).degenerate_faces, 21u);
  EXPECT_TRUE(same_smoothing(result_, smoothed(clean, GetParam().parameters), GetParam(), average_edge_length(clean)));
}

TEST_P(DegenerateMeshes, FacesWithoutArea) {
  FlatMesh shape = height_field(8, [](double x, double y) { return 0.1 * x * x - 0.2 * x * y; });
  // The edge 18-19 is split at its middle on one side only: the other is filled by a face without area.
  shape.points.push_back((shape.points[18] + shape.points[19]) / 2);
  const std::size_t middle = shape.points.size() - 1;
  shape.faces.push_back({18, middle, 19});
  EXPECT_EQ(run(shape).degenerate_faces, 1u);
  expect_as_reference(shape);
}

TEST_P(DegenerateMeshes, VerticesThatCollapsedIntoOne) {
  FlatMesh shape = potato(2);
  const Triangle collapsed = shape.faces[100];
  shape.points[collapsed[0]] = shape.points[collapsed[1]] = shape.points[collapsed[2]];
  const SmoothingReport report = run(shape);
  EXPECT_EQ(report.coincident_vertices, 3u);
  EXPECT_EQ(report.degenerate_faces, 4u);  // and those beside its three edges
  expect_as_reference(shape);
}

TEST_P(DegenerateMeshes, DuplicatedFaces) {
  FlatMesh shape = potato(2);
  for (std::size_t f = 0; f < 40; ++f) shape.faces.push_back(shape.faces[f]);
  EXPECT_GT(run(shape).non_manifold_vertices, 0u);
  expect_as_reference(shape);
}

TEST_P(DegenerateMeshes, OppositeFacesThatCancelNormals) {
  const FlatMesh sheet = height_field(6, [](double x, double y) { return 0.05 * x * y; });
  FlatMesh shape = sheet;
  for (const Triangle& f : sheet.faces) shape.faces.push_back({f[0], f[2], f[1]});
  const SmoothingReport report = run(shape);
  EXPECT_EQ(report.skipped_vertices.undefined_normal, sheet.points.size());
  EXPECT_EQ(report.moved_vertices, 0u);
  EXPECT_TRUE(same_bits(result_, shape));
}

// Only some cancel: they stay, and offer nothing to their neighbours.
TEST_P(DegenerateMeshes, VerticesWithoutNormalAmongOthers) {
  FlatMesh shape = potato(2);
  shape.points.emplace_back(2, 0, 0);
  shape.points.emplace_back(2, 0.1, 0);
  const std::size_t a = shape.points.size() - 2;
  shape.faces.push_back({0, a, a + 1});
  shape.faces.push_back({0, a + 1, a});
  EXPECT_EQ(run(shape).skipped_vertices.undefined_normal, 2u);
  expect_as_reference(shape);
}

TEST_P(DegenerateMeshes, NonManifoldEdgesAndVertices) {
  FlatMesh book = grid(6);
  for (int page = 0; page < 2; ++page) {
    const FlatMesh leaf = transformed(grid(6), [&](const Point& p) {
      return Point(-p[0] * 0.7, p[1], (page == 0 ? 1 : -1) * (p[0] + 0.1 * p[1] * p[0]));
    });
    const std::size_t offset = book.points.size();
    append(book, leaf);
    // Bind it: the leaf's left side is the book's.
    for (Triangle& f : book.faces)
      for (std::size_t& v : f)
        if (v >= offset && (v - offset) % 6 == 0) v -= offset;
  }
  const SmoothingReport report = run(book);
  // The sides that were bound are still there, without faces, in the places of the book's.
  EXPECT_EQ(report.non_manifold_vertices, 6u + 12u);
  EXPECT_EQ(report.skipped_vertices.isolated, 0u);
  expect_as_reference(book);
}

TEST_P(DegenerateMeshes, FacesOfBothOrientations) {
  FlatMesh shape = potato(2);
  for (std::size_t f = 0; f < shape.faces.size(); f += 3) std::swap(shape.faces[f][0], shape.faces[f][1]);
  run(shape);
  expect_as_reference(shape);
}

TEST_P(DegenerateMeshes, UnmergedTriangles) {
  const FlatMesh clean = potato(1);
  FlatMesh soup;
  for (const Triangle& f : clean.faces) {
    const std::size_t first = soup.points.size();
    for (const std::size_t v : f) soup.points.push_back(clean.points[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  const SmoothingReport report = run(soup);
  EXPECT_EQ(report.coincident_vertices, soup.points.size());
  EXPECT_EQ(report.moved_vertices, soup.points.size());
  EXPECT_EQ(report.border_vertices, 0u);
  expect_as_reference(soup);
}

TEST_P(DegenerateMeshes, OneTriangle) {
  const FlatMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(run(triangle).fixed_vertices, 3u);
  EXPECT_TRUE(same_bits(result_, triangle));
}

TEST_P(DegenerateMeshes, EdgesOfVeryDifferentLengths) {
  FlatMesh shape = potato(2);
  for (std::size_t v = 0; v < 12; ++v) shape.points[v] = shape.points[v] * 1000.0;  // twelve spikes
  run(shape);
  expect_as_reference(shape);
}

TEST_P(DegenerateMeshes, NeedleTriangles) {
  const FlatMesh shape = transformed(potato(2), [](const Point& p) { return Point(p[0] * 1e-7, p[1], p[2] * 1e3); });
  run(shape);
  // Sides of 1e10 to 1 turn a rounding of 1e-16 into a distance of some 1e-6 of the longer one.
  run(shape, 1);
  SmoothingPath path = GetParam();
  path.position_tolerance = std::max(path.position_tolerance, 1e-5);
  const FlatMesh expected = naive_smooth(shape, path.parameters, 1);
  EXPECT_TRUE(same_smoothing(result_, expected, path, average_edge_length(shape)));
}

// The volume of such a mesh is no double any more; its vertices are.
TEST_P(DegenerateMeshes, CoordinatesAtTheEndsOfTheRange) {
  for (const double scale : {std::numeric_limits<double>::max() / 2, std::numeric_limits<double>::denorm_min() * 64}) {
    const FlatMesh shape = transformed(octahedron(), [&](const Point& p) { return p * scale; });
    const FlatMesh result = smoothed(shape, GetParam().parameters);
    EXPECT_TRUE(all_finite(result));
    for (std::size_t v = 0; v < 6; ++v) EXPECT_NE(result.points[v], shape.points[v]);
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, DegenerateMeshes, testing::ValuesIn(smoothing_paths()), name_of_path);

}  // namespace
