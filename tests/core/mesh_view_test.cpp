// SPDX-License-Identifier: GPL-3.0-or-later
// The entry points on arrays of the caller's: any types and strides give the same result, and nothing else is touched.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/mesh_census.h>
#include <support/noisy_shapes.h>
#include <support/packed.h>
#include <support/smoothed_by.h>
#include <vcg_core/geodesic_distance.h>
#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::MeshView;
using vcg_core::Method;

template <class Real, class Integer>
std::vector<Real> smoothed_packed(const FlatMesh& mesh, Method method) {
  Packed<Real, Integer> packed(mesh);
  smooth(packed.view(), method, vcg_core::method_info(method).defaults);
  return packed.positions;
}

TEST(MeshView, AllTypesOfIndicesGiveTheSame) {
  const FlatMesh shape = noisy_shape("torus", 500);
  const std::vector<double> expected = smoothed_packed<double, std::uint32_t>(shape, Method::guided);
  EXPECT_EQ((smoothed_packed<double, std::int32_t>(shape, Method::guided)), expected);
  EXPECT_EQ((smoothed_packed<double, std::int64_t>(shape, Method::guided)), expected);
  EXPECT_EQ((smoothed_packed<double, std::uint64_t>(shape, Method::guided)), expected);
}

TEST(MeshView, GivesWhatAVcglibMeshGives) {
  const FlatMesh shape = noisy_shape("cad_part", 500);
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    Packed<double> packed(shape);
    const vcg_core::SmoothingReport report = smooth(packed.view(), method.method, method.defaults);
    const SmoothedBy expected = smoothed_by(method.method, shape);
    for (std::size_t v = 0; v < shape.points.size(); ++v) EXPECT_EQ(packed.point(v), expected.mesh.points[v]);
    EXPECT_EQ(report.moved_vertices, expected.report.moved_vertices);
    EXPECT_EQ(report.max_displacement, expected.report.max_displacement);
  }
}

TEST(MeshView, RoundsToSinglePrecisionOnceAndAtTheEnd) {
  const FlatMesh shape = noisy_shape("sphere", 500);
  Packed<float> single(shape);
  Packed<double> wide(shape);
  std::copy(single.positions.begin(), single.positions.end(), wide.positions.begin());
  smooth(single.view(), Method::paper);
  smooth(wide.view(), Method::paper);
  for (std::size_t k = 0; k < wide.positions.size(); ++k)
    EXPECT_EQ(single.positions[k], static_cast<float>(wide.positions[k]));
}

// Rows of 29 bytes, at odd addresses, from the last to the first.
TEST(MeshView, TakesRowsThatAreNotAlignedAndRunBackwards) {
  const FlatMesh shape = noisy_shape("sphere", 300);
  const Packed<double> packed(shape);
  constexpr std::size_t row = 29;
  std::vector<char> bytes(row * packed.vertices() + 1, 'x');
  const auto place = [&](std::size_t v) { return &bytes[1 + row * (packed.vertices() - 1 - v)]; };
  for (std::size_t v = 0; v < packed.vertices(); ++v) std::memcpy(place(v), &packed.positions[3 * v], 24);
  std::vector<std::int64_t> triangles;
  for (const Triangle& f : shape.faces) {
    triangles.insert(triangles.end(), f.begin(), f.end());
    triangles.push_back(-1);  // not of the mesh
  }
  MeshView view;
  view.vertices = packed.vertices();
  view.faces = shape.faces.size();
  view.positions.data = place(0);
  view.positions.stride = -static_cast<std::ptrdiff_t>(row);
  view.triangles = vcg_core::index_rows(triangles.data(), 4 * sizeof(std::int64_t));
  smooth(view, Method::paper);

  const std::vector<double> expected = smoothed_packed<double, std::uint32_t>(shape, Method::paper);
  for (std::size_t v = 0; v < packed.vertices(); ++v) {
    EXPECT_EQ(std::memcmp(place(v), &expected[3 * v], 24), 0);
    EXPECT_EQ(std::string(place(v) + 24, 5), "xxxxx");
  }
}

std::string refusal(const MeshView& view, const vcg_core::SmoothingLimits& limits = {}) {
  try {
    smooth(view, Method::paper, {}, {}, limits);
  } catch (const vcg_core::Error& error) {
    return error.what();
  }
  return "";
}

template <class Integer>
void expect_refused_index(Integer index) {
  Packed<double, Integer> packed(potato(1));
  const std::vector<double> before = packed.positions;
  packed.triangles[3 * 5 + 1] = index;
  EXPECT_EQ(refusal(packed.view()), "face 5 refers to a vertex that the mesh does not have") << index;
  EXPECT_EQ(packed.positions, before);
}

TEST(MeshView, RefusesIndicesThatAreNoVertex) {
  const auto vertices = static_cast<std::int32_t>(potato(1).points.size());
  expect_refused_index<std::int32_t>(vertices);
  expect_refused_index<std::int32_t>(-1);
  expect_refused_index<std::int32_t>(std::numeric_limits<std::int32_t>::min());
  expect_refused_index<std::uint32_t>(std::numeric_limits<std::uint32_t>::max());
  expect_refused_index<std::int64_t>(-1);
  expect_refused_index<std::int64_t>(std::int64_t(1) << 32);  // 0 in 32 bits
  expect_refused_index<std::uint64_t>(std::numeric_limits<std::uint64_t>::max());
}

TEST(MeshView, RefusesAMeshOfNothing) {
  EXPECT_NE(refusal({}).find("has no faces"), std::string::npos);
  EXPECT_THROW(vcg_core::summarize({}), vcg_core::InvalidMesh);
  EXPECT_THROW(vcg_core::vertex_normals({}), vcg_core::InvalidMesh);
  EXPECT_THROW(vcg_core::estimate_noise({}), vcg_core::InvalidMesh);
  EXPECT_THROW(vcg_core::geodesic_distances(MeshView{}, 0), vcg_core::InvalidMesh);
}

TEST(MeshView, RefusesElementsWithoutMemory) {
  Packed<double> packed(potato(1));
  MeshView no_positions = packed.view(), no_triangles = packed.view(), no_creases = packed.view();
  no_positions.positions = {};
  no_triangles.triangles = {};
  no_creases.crease_count = 1;
  for (const MeshView& view : {no_positions, no_triangles, no_creases})
    EXPECT_EQ(refusal(view), "the view counts elements that it has no memory of");
}

TEST(MeshView, MovesSelectedVerticesAndThoseOfSelectedFacesOnly) {
  Packed<double> packed(potato(2));
  const std::vector<double> before = packed.positions;
  std::vector<std::uint8_t> vertex(packed.vertices(), 0);
  std::vector<std::uint32_t> face(packed.triangles.size() / 3, 4);  // a bit that is not asked for
  vertex[7] = 1;
  face[11] |= 2;
  MeshView view = packed.view();
  view.selected_vertices.data = vertex.data();
  view.selected_faces = {face.data(), 4, 2, 4};
  vcg_core::SmoothingParameters parameters;
  parameters.selected_only = true;
  EXPECT_EQ(smooth(view, Method::paper, parameters).moved_vertices, 4u);
  for (std::size_t v = 0; v < packed.vertices(); ++v) {
    const auto* const corners = &packed.triangles[3 * 11];
    const bool selected = v == 7 || std::count(corners, corners + 3, v) > 0;
    EXPECT_EQ(std::memcmp(&packed.positions[3 * v], &before[3 * v], 24) != 0, selected) << v;
  }
}

TEST(MeshView, SmoothsColorsAndScalarsOnRequest) {
  const FlatMesh shape = noisy_shape("plane_slash", 400);
  const auto run = [&](bool smooth_color) {
    Packed<double> packed(shape);
    std::vector<std::uint8_t> colors(5 * packed.vertices());
    std::vector<float> scalars(packed.vertices());
    for (std::size_t v = 0; v < packed.vertices(); ++v) {
      for (std::size_t k = 0; k < 5; ++k) colors[5 * v + k] = v % 2 == 0 ? 100 : 140;
      scalars[v] = v % 2 == 0 ? 1.0f : 3.0f;
    }
    MeshView view = packed.view();
    view.colors = {colors.data(), 5};
    view.scalars = vcg_core::real_rows(scalars.data(), sizeof(float));
    vcg_core::SmoothingParameters parameters = vcg_core::method_info(Method::guided).defaults;
    parameters.smooth_color = smooth_color;
    smooth(view, Method::guided, parameters);
    double spread = 0;
    for (std::size_t v = 0; v < packed.vertices(); ++v) {
      EXPECT_EQ(colors[5 * v + 4], v % 2 == 0 ? 100 : 140);  // the byte between the rows
      EXPECT_NEAR(scalars[v], 1 + (colors[5 * v] - 100) / 20.0, 0.03);
      spread = std::max<double>(spread, std::abs(scalars[v] - 2.0f));
    }
    return spread;
  };
  EXPECT_EQ(run(false), 1);
  EXPECT_LT(run(true), 0.3);
}

TEST(MeshView, WeightsScaleTheMovementOfAPass) {
  const FlatMesh shape = noisy_shape("sphere", 500);
  const Packed<double> before(shape);
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    vcg_core::SmoothingParameters one_pass = method.defaults;
    one_pass.iterations = 1;
    Packed<double> full(shape), weighted(shape);
    smooth(full.view(), method.method, one_pass);
    const std::vector<float> weights(full.vertices(), 0.25f);
    MeshView view = weighted.view();
    view.weights = vcg_core::real_rows(const_cast<float*>(weights.data()), sizeof(float));
    smooth(view, method.method, one_pass);
    for (std::size_t v = 0; v < full.vertices(); ++v)
      EXPECT_LT((weighted.point(v) - (before.point(v) * 0.75 + full.point(v) * 0.25)).Norm(), 1e-14) << method.name;
  }
}

// In every pass, so that the others see it where it is.
TEST(MeshView, AVertexOfWeightZeroStaysBitForBit) {
  const FlatMesh shape = noisy_shape("sphere", 500);
  const Packed<double> before(shape);
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    Packed<double> packed(shape);
    std::vector<double> weights(packed.vertices(), 1);
    weights[3] = weights[40] = 0;
    MeshView view = packed.view();
    view.weights = vcg_core::real_rows(weights.data(), sizeof(double));
    const vcg_core::SmoothingReport report = smooth(view, method.method, method.defaults);
    EXPECT_EQ(report.fixed_vertices, 2u) << method.name;
    EXPECT_EQ(report.moved_vertices, packed.vertices() - 2) << method.name;
    for (const std::size_t v : {3, 40}) EXPECT_EQ(packed.point(v), before.point(v)) << method.name;
  }
}

TEST(MeshView, WeightsOfOneChangeNothing) {
  const FlatMesh shape = noisy_shape("cube", 500);
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    Packed<double> plain(shape), weighted(shape);
    std::vector<double> weights(plain.vertices(), 1);
    MeshView view = weighted.view();
    view.weights = vcg_core::real_rows(weights.data(), sizeof(double));
    smooth(plain.view(), method.method, method.defaults);
    smooth(view, method.method, method.defaults);
    EXPECT_EQ(weighted.positions, plain.positions) << method.name;
  }
}

TEST(MeshView, RefusesWeightsOutOfRange) {
  for (const double bad : {-0.1, 1.5, std::nan("")}) {
    Packed<double> packed(potato(1));
    const std::vector<double> before = packed.positions;
    std::vector<double> weights(packed.vertices(), 1);
    weights[6] = bad;
    MeshView view = packed.view();
    view.weights = vcg_core::real_rows(weights.data(), sizeof(double));
    EXPECT_EQ(refusal(view).find("the weight of vertex 6 is "), 0u) << refusal(view);
    EXPECT_EQ(packed.positions, before);
  }
}

TEST(MeshView, NoVertexMovesFartherThanAllowed) {
  const FlatMesh shape = noisy_shape("sphere", 500);
  const Packed<double> before(shape);
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    Packed<double> free(shape), held(shape);
    const double farthest = smooth(free.view(), method.method, method.defaults).max_displacement;
    vcg_core::SmoothingLimits limits;
    limits.max_displacement = farthest / 3;
    const vcg_core::SmoothingReport report = smooth(held.view(), method.method, method.defaults, {}, limits);
    std::size_t stopped = 0;
    for (std::size_t v = 0; v < held.vertices(); ++v) {
      const double step = (held.point(v) - before.point(v)).Norm();
      EXPECT_LE(step, limits.max_displacement * (1 + 1e-9)) << method.name;
      stopped += step > limits.max_displacement * (1 - 1e-9);
    }
    EXPECT_GT(stopped, 0u) << method.name;
    EXPECT_GE(report.bounded_vertices, stopped) << method.name;
    EXPECT_LE(report.max_displacement, limits.max_displacement * (1 + 1e-9)) << method.name;
  }
}

TEST(MeshView, NothingMovesWhereNoMovementIsAllowed) {
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    Packed<float> packed(noisy_shape("cube", 500));
    const std::vector<float> before = packed.positions;
    vcg_core::SmoothingLimits limits;
    limits.max_displacement = 0;
    const vcg_core::SmoothingReport report = smooth(packed.view(), method.method, method.defaults, {}, limits);
    EXPECT_EQ(packed.positions, before) << method.name;
    EXPECT_EQ(report.moved_vertices, 0u) << method.name;
  }
}

TEST(MeshView, RefusesLimitsOutOfRange) {
  Packed<double> packed(potato(1));
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, nan, infinity}) {
    vcg_core::SmoothingLimits limits;
    limits.weld_distance = bad;
    EXPECT_EQ(refusal(packed.view(), limits).find("weld_distance is "), 0u);
  }
  for (const double bad : {-1.0, nan}) {
    vcg_core::SmoothingLimits limits;
    limits.max_displacement = bad;
    EXPECT_EQ(refusal(packed.view(), limits).find("max_displacement is "), 0u);
  }
}

TEST(MeshMeasures, SummaryOfACubeIsAnalytic) {
  // Of edge 1, two triangles a side.
  Packed<double> packed(cube());
  const vcg_core::MeshSummary summary = vcg_core::summarize(packed.view());
  EXPECT_EQ(summary.vertices, 8u);
  EXPECT_EQ(summary.faces, 12u);
  EXPECT_EQ(summary.border_vertices + summary.non_manifold_vertices + summary.isolated_vertices, 0u);
  EXPECT_EQ(summary.coincident_vertices + summary.degenerate_faces, 0u);
  EXPECT_NEAR(summary.average_edge_length, (12 + 6 * std::sqrt(2.0)) / 18, 1e-14);
  EXPECT_NEAR(summary.volume, 1, 1e-14);
}

TEST(MeshMeasures, SummaryCountsAsTheCensusDoes) {
  FlatMesh shape = height_field(6, [](double x, double y) { return x * y; });
  shape.points.emplace_back(9, 9, 9);  // isolated
  shape.faces.push_back({0, 1, 1});
  const MeshCensus census = take_census(shape);
  Packed<double> packed(shape);
  const vcg_core::MeshSummary summary = vcg_core::summarize(packed.view());
  EXPECT_EQ(summary.vertices, shape.points.size());
  EXPECT_EQ(summary.isolated_vertices, census.isolated);
  EXPECT_EQ(summary.border_vertices, census.border);
  EXPECT_EQ(summary.non_manifold_vertices, census.non_manifold);
  EXPECT_EQ(summary.degenerate_faces, census.degenerate_faces);
}

TEST(MeshMeasures, NormalsOfASpherePointOutwards) {
  const FlatMesh sphere = noisy_shape("sphere", 2000, 0);
  Packed<float, std::int64_t> packed(sphere);
  const auto normals = vcg_core::vertex_normals(packed.view());
  ASSERT_EQ(normals.size(), packed.vertices());
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Point n(normals[v][0], normals[v][1], normals[v][2]);
    EXPECT_NEAR(n.Norm(), 1, 1e-12);
    EXPECT_GT(n * packed.point(v) / packed.point(v).Norm(), 0.99);
  }
}

TEST(MeshMeasures, NoiseIsWhatTheGuidedFilterReports) {
  for (const double scale : {1.0, 1e-30, 1e30}) {
    const FlatMesh shape = transformed(noisy_shape("sphere", 2000), [&](const Point& p) { return p * scale; });
    Packed<double> packed(shape);
    const double noise = vcg_core::estimate_noise(packed.view());
    EXPECT_GT(noise, 0);
    EXPECT_EQ(noise, smoothed_by(Method::guided, shape).report.estimated_noise);
  }
}

TEST(MeshMeasures, DistancesAreThoseOfAVcglibMesh) {
  const FlatMesh shape = noisy_shape("torus", 500);
  DoubleMesh mesh;
  fill(mesh, shape);
  Packed<double, std::int32_t> packed(shape);
  EXPECT_EQ(vcg_core::geodesic_distances(packed.view(), 17), vcg_core::geodesic_distances(mesh, 17));
  EXPECT_THROW(vcg_core::geodesic_distances(packed.view(), shape.points.size()), vcg_core::InvalidParameter);
}

}  // namespace
