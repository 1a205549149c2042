// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices at the same place are one: a mesh that is split along seams, or into a soup of triangles, comes out with the
// bits of the whole one, whatever the order of the copies.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/hand_made.h>
#include <support/noisy_shapes.h>
#include <support/packed.h>
#include <support/print_method.h>
#include <support/split_mesh.h>
#include <support/test_data.h>
#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::MeshView;
using vcg_core::Method;
using vcg_core::SmoothingLimits;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;

template <class Real>
void expect_as_whole(const FlatMesh& whole, const SplitMesh& split, Method method,
                     const SmoothingParameters& parameters) {
  Packed<Real> expected(whole), found(split.mesh);
  const SmoothingReport a = smooth(expected.view(), method, parameters);
  const SmoothingReport b = smooth(found.view(), method, parameters);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < split.original.size(); ++v) {
    EXPECT_EQ(found.point(v), expected.point(split.original[v])) << vcg_core::method_name(method);
    moved += found.point(v) != Packed<Real>(FlatMesh{{split.mesh.points[v]}, {}}).point(0);
  }
  EXPECT_EQ(b.vertices, split.original.size());
  EXPECT_EQ(b.moved_vertices, moved);
  EXPECT_EQ(b.average_edge_length, a.average_edge_length);
  EXPECT_EQ(b.estimated_noise, a.estimated_noise);
  EXPECT_EQ(b.volume_before, a.volume_before);
  EXPECT_EQ(b.volume_after, a.volume_after);
  EXPECT_EQ(b.max_displacement, a.max_displacement);
  EXPECT_EQ(b.flipped_faces, a.flipped_faces);
  EXPECT_EQ(b.closed, a.closed);
  EXPECT_EQ(b.border_vertices == 0, a.border_vertices == 0);
  EXPECT_EQ(b.degenerate_faces, a.degenerate_faces);
}

template <class Real>
void expect_as_whole(const FlatMesh& whole, Method method) {
  const SmoothingParameters& defaults = vcg_core::method_info(method).defaults;
  for (const unsigned seed : {1u, 2u})
    expect_as_whole<Real>(whole, split(whole, random_charts(whole, 9, seed), seed), method, defaults);
  expect_as_whole<Real>(whole, split(whole, single_faces(whole), 3), method, defaults);
}

class SplitMeshes : public testing::TestWithParam<Method> {};

TEST_P(SplitMeshes, ComeOutAsTheWholeOne) {
  for (const char* const shape : {"cube", "cad_part", "thin_sheets", "plane_delaunay"}) {
    SCOPED_TRACE(shape);
    expect_as_whole<double>(noisy_shape(shape, 400), GetParam());
    expect_as_whole<float>(noisy_shape(shape, 400), GetParam());
  }
}

// All vertices but one in one cell of the spatial order: only coordinates can tell which comes first.
TEST_P(SplitMeshes, ComeOutAsTheWholeOneBesideAFarVertex) {
  FlatMesh shape = transformed(potato(2), [](const Point& p) { return p * 1e-9; });
  shape.points.emplace_back(1, 1, 1);
  expect_as_whole<double>(shape, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Methods, SplitMeshes,
                         testing::Values(Method::paper, Method::bmd, Method::jones, Method::laplacian, Method::hc,
                                         Method::hc_vcglib, Method::taubin, Method::guided),
                         [](const auto& instance) { return vcg_core::method_name(instance.param); });

TEST(SplitScan, ComesOutAsTheWholeOne) {
  const auto model = load_model("Bunny0.2");
  if (!model) GTEST_SKIP() << "no model Bunny0.2 in ANISO_TEST_DATA";
  const FlatMesh& whole = model->noisy;
  for (const Method method : {Method::paper, Method::guided})
    expect_as_whole<float>(whole, split(whole, random_charts(whole, 50, 7), 7), method,
                           vcg_core::method_info(method).defaults);
}

TEST(SplitMesh, HasTheMeasuresOfTheWholeOne) {
  const FlatMesh shape = noisy_shape("torus", 500);
  const SplitMesh soup = split(shape, single_faces(shape), 5);
  Packed<double> whole(shape), parts(soup.mesh);
  const vcg_core::MeshSummary a = vcg_core::summarize(whole.view()), b = vcg_core::summarize(parts.view());
  EXPECT_EQ(b.border_vertices, 0u);
  EXPECT_EQ(b.coincident_vertices, soup.original.size());
  EXPECT_EQ(b.average_edge_length, a.average_edge_length);
  EXPECT_EQ(b.volume, a.volume);
  EXPECT_EQ(vcg_core::estimate_noise(parts.view()), vcg_core::estimate_noise(whole.view()));
  const auto normal_of_whole = vcg_core::vertex_normals(whole.view());
  const auto normal = vcg_core::vertex_normals(parts.view());
  const auto distance_of_whole = vcg_core::geodesic_distances(whole.view(), soup.original[11]);
  const auto distance = vcg_core::geodesic_distances(parts.view(), 11);
  for (std::size_t v = 0; v < soup.original.size(); ++v) {
    EXPECT_EQ(normal[v], normal_of_whole[soup.original[v]]);
    EXPECT_EQ(distance[v], distance_of_whole[soup.original[v]]);
  }
}

// A vertex that no face has, in the place of another.
TEST(SplitMesh, ACopyWithoutFacesMovesAlong) {
  FlatMesh shape = potato(2);
  shape.points.push_back(shape.points[10]);
  Packed<double> packed(shape);
  const SmoothingReport report = smooth(packed.view(), Method::paper);
  EXPECT_EQ(report.skipped_vertices.isolated, 0u);
  EXPECT_EQ(report.moved_vertices, shape.points.size());
  EXPECT_EQ(packed.point(10), packed.point(shape.points.size() - 1));
}

TEST(SplitMesh, IsSelectedWhereOneOfTheCopiesIs) {
  const FlatMesh shape = potato(2);
  const SplitMesh soup = split(shape, single_faces(shape), 5);
  std::vector<std::uint8_t> selected(soup.original.size(), 0);
  selected[20] = 1;
  Packed<double> packed(soup.mesh);
  const std::vector<double> before = packed.positions;
  MeshView view = packed.view();
  view.selected_vertices.data = selected.data();
  SmoothingParameters parameters;
  parameters.selected_only = true;
  smooth(view, Method::paper, parameters);
  for (std::size_t v = 0; v < soup.original.size(); ++v)
    EXPECT_EQ(packed.point(v) != soup.mesh.points[v], soup.original[v] == soup.original[20]) << v;
}

TEST(SplitMesh, HasTheSmallestWeightOfTheCopies) {
  const FlatMesh shape = potato(2);
  const SplitMesh soup = split(shape, single_faces(shape), 5);
  std::vector<double> weights(soup.original.size(), 1);
  weights[20] = 0;
  Packed<double> packed(soup.mesh);
  MeshView view = packed.view();
  view.weights = vcg_core::real_rows(weights.data(), sizeof(double));
  smooth(view, Method::paper);
  for (std::size_t v = 0; v < soup.original.size(); ++v)
    EXPECT_EQ(packed.point(v) == soup.mesh.points[v], soup.original[v] == soup.original[20]) << v;
}

/// The scalars of a mesh after they were smoothed.
std::vector<double> smoothed_scalars(const FlatMesh& mesh, std::vector<double> scalars) {
  Packed<double> packed(mesh);
  MeshView view = packed.view();
  view.scalars = vcg_core::real_rows(scalars.data(), sizeof(double));
  SmoothingParameters parameters = vcg_core::method_info(Method::guided).defaults;
  parameters.smooth_color = true;
  smooth(view, Method::guided, parameters);
  return scalars;
}

TEST(ScalarsOfCopies, ThatAreEqualAreSmoothedAsOne) {
  const FlatMesh shape = noisy_shape("sphere", 400);
  std::vector<double> given(shape.points.size());
  for (std::size_t v = 0; v < given.size(); ++v)
    given[v] = v % 7 == 0 ? std::nan("") : std::sin(static_cast<double>(v));
  const std::vector<double> expected = smoothed_scalars(shape, given);
  const SplitMesh soup = split(shape, single_faces(shape), 5);
  std::vector<double> of_copies;
  for (const std::size_t v : soup.original) of_copies.push_back(given[v]);
  const std::vector<double> found = smoothed_scalars(soup.mesh, of_copies);
  for (std::size_t v = 0; v < found.size(); ++v) {
    EXPECT_NE(found[v], of_copies[v]);  // or none of them is a number
    const double whole = expected[soup.original[v]];
    EXPECT_TRUE(found[v] == whole || (std::isnan(found[v]) && std::isnan(whole))) << v;
  }
}

// Two halves of a plane, of different scalars: nothing crosses the seam.
TEST(ScalarsOfCopies, ThatDifferStayOnTheirSideOfTheSeam) {
  const FlatMesh plane = noisy_shape("plane_slash", 400);
  double middle = 0;
  for (const Point& p : plane.points) middle += p[0] / static_cast<double>(plane.points.size());
  std::vector<std::size_t> chart;
  for (const Triangle& f : plane.faces)
    chart.push_back(plane.points[f[0]][0] + plane.points[f[1]][0] + plane.points[f[2]][0] < 3 * middle);
  const SplitMesh halves = split(plane, chart, 5);
  std::vector<double> given(halves.original.size(), 0);
  for (std::size_t f = 0; f < chart.size(); ++f)
    for (const std::size_t v : halves.mesh.faces[f]) given[v] = chart[f] == 0 ? 5 : 9;
  const std::vector<double> found = smoothed_scalars(halves.mesh, given);
  for (std::size_t v = 0; v < found.size(); ++v) EXPECT_NEAR(found[v], given[v], 1e-12);
}

/// A soup whose corners lie up to `gap` from where they belong, each elsewhere.
SplitMesh jittered_soup(const FlatMesh& shape, double gap) {
  SplitMesh soup = split(shape, single_faces(shape), 5);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-gap / 4, gap / 4);  // two of them are less than `gap` apart
  for (Point& p : soup.mesh.points) p += Point(offset(random), offset(random), offset(random));
  return soup;
}

TEST(WeldDistance, JoinsWhatIsNearlyAtTheSamePlace) {
  const FlatMesh shape = noisy_shape("cad_part", 400);
  const double gap = 1e-6;
  const SplitMesh soup = jittered_soup(shape, gap);
  SmoothingLimits limits;
  limits.weld_distance = gap;
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    Packed<double> whole(shape), parts(soup.mesh);
    smooth(whole.view(), method.method, method.defaults);
    const SmoothingReport report = smooth(parts.view(), method.method, method.defaults, {}, limits);
    EXPECT_EQ(report.border_vertices, 0u);
    EXPECT_TRUE(report.closed);
    EXPECT_EQ(report.coincident_vertices, soup.original.size());
    // The filters follow the noise of the gaps and no more; each corner keeps its own place in the gap.
    std::vector<Point> step(shape.points.size(), Point(0, 0, 0));
    for (std::size_t v = 0; v < soup.original.size(); ++v) {
      EXPECT_LT((parts.point(v) - whole.point(soup.original[v])).Norm(), 1e3 * gap) << method.name;
      const Point moved = parts.point(v) - soup.mesh.points[v];
      Point& of_place = step[soup.original[v]];
      if (of_place == Point(0, 0, 0)) of_place = moved;
      EXPECT_LT((moved - of_place).Norm(), 1e-14) << method.name;
    }
  }
}

/// The value of --weld-distance that a warning names; 0 if none does.
double distance_named(const SmoothingReport& report) {
  for (const std::string& sentence : report.warnings()) {
    const std::string option = "--weld-distance ";
    const std::size_t place = sentence.find(option);
    if (place != std::string::npos) return std::stod(sentence.substr(place + option.size()));
  }
  return 0;
}

TEST(WeldDistance, IsNamedByAWarningWhereItWouldCloseTheSurface) {
  const FlatMesh shape = noisy_shape("cad_part", 400);
  for (const double gap : {1e-7, 3e-6, 1e-5}) {
    for (const bool soup : {true, false}) {
      SplitMesh torn = split(shape, soup ? single_faces(shape) : random_charts(shape, 5, 1), 5);
      std::mt19937 random(1);
      std::uniform_real_distribution<double> offset(-gap / 4, gap / 4);
      for (Point& p : torn.mesh.points) p += Point(offset(random), offset(random), offset(random));
      Packed<double> packed(torn.mesh);
      SmoothingLimits limits;
      const SmoothingReport report = smooth(packed.view(), Method::paper, {}, {}, limits);
      EXPECT_EQ(report.nearly_coincident_vertices, report.border_vertices);
      limits.weld_distance = distance_named(report);
      ASSERT_GT(limits.weld_distance, 0);
      EXPECT_LT(limits.weld_distance, 2 * gap);
      Packed<double> again(torn.mesh);
      const SmoothingReport joined = smooth(again.view(), Method::paper, {}, {}, limits);
      EXPECT_TRUE(joined.closed);
      EXPECT_EQ(joined.nearly_coincident_vertices, 0u);
      EXPECT_EQ(distance_named(joined), 0);
    }
  }
}

// Borders as they are meant to be: far from each other, or of fine parts whose edges are short.
TEST(WeldDistance, IsNotNamedForOrdinaryBorders) {
  FlatMesh fine =
      transformed(height_field(20, [](double x, double y) { return x * y; }), [](const Point& p) { return p * 1e-7; });
  append(fine, noisy_shape("plane_delaunay", 400));
  for (const FlatMesh& shape : {noisy_shape("plane_delaunay", 400), noisy_shape("thin_sheets", 400), fine}) {
    Packed<double> packed(shape);
    const SmoothingReport report = smooth(packed.view(), Method::bmd);
    EXPECT_GT(report.border_vertices, 0u);
    EXPECT_EQ(distance_named(report), 0);
  }
}

TEST(WeldDistance, DoesNotDependOnTheOrderOfTheCopies) {
  const FlatMesh shape = noisy_shape("sphere", 300);
  const SplitMesh soup = jittered_soup(shape, 1e-3);
  FlatMesh turned = soup.mesh;
  std::reverse(turned.points.begin(), turned.points.end());
  for (Triangle& f : turned.faces)
    for (std::size_t& v : f) v = turned.points.size() - 1 - v;
  SmoothingLimits limits;
  limits.weld_distance = 1e-3;
  Packed<double> a(soup.mesh), b(turned);
  smooth(a.view(), Method::paper, {}, {}, limits);
  smooth(b.view(), Method::paper, {}, {}, limits);
  for (std::size_t v = 0; v < a.vertices(); ++v) EXPECT_EQ(a.point(v), b.point(a.vertices() - 1 - v));
}

TEST(WeldDistance, ChangesNothingWhereNothingIsNear) {
  const FlatMesh shape = noisy_shape("sphere", 300);
  SmoothingLimits limits;
  limits.weld_distance = 1e-6;
  Packed<double> a(shape), b(shape);
  smooth(a.view(), Method::paper);
  smooth(b.view(), Method::paper, {}, {}, limits);
  EXPECT_EQ(a.positions, b.positions);
}

// With the scale of the mesh, however large or small: only the unit is another.
TEST(WeldDistance, IsInTheMeshsUnit) {
  const FlatMesh shape = noisy_shape("sphere", 300);
  const SplitMesh soup = jittered_soup(shape, 1e-3);
  for (const double scale : {std::ldexp(1, -200), 1.0, std::ldexp(1, 300)}) {
    Packed<double> packed(transformed(soup.mesh, [&](const Point& p) { return p * scale; }));
    SmoothingLimits limits;
    limits.weld_distance = 1e-3 * scale;
    EXPECT_EQ(smooth(packed.view(), Method::bmd, {}, {}, limits).border_vertices, 0u) << scale;
    limits.weld_distance = 0;
    EXPECT_EQ(smooth(packed.view(), Method::bmd, {}, {}, limits).border_vertices, packed.vertices()) << scale;
  }
}

}  // namespace
