// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of a larger mesh, with its surroundings, comes out as in the whole.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/noisy_shapes.h>
#include <support/packed.h>
#include <vcg_core/mesh/guided_measures.h>
#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::Method;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;
using vcg_core::WholeMesh;

WholeMesh whole_of(const FlatMesh& mesh) {
  WholeMesh whole;
  whole.average_edge_length = average_edge_length(mesh);
  for (int k = 0; k < 3; ++k) {
    const auto less = [k](const Point& a, const Point& b) { return a[k] < b[k]; };
    const auto [least, largest] = std::minmax_element(mesh.points.begin(), mesh.points.end(), less);
    whole.box_min[k] = (*least)[k];
    whole.box_max[k] = (*largest)[k];
  }
  return whole;
}

/// The vertices on one side of a plane, what lies within `reach` of it, and the faces of all these.
struct Part {
  FlatMesh mesh;
  std::vector<std::size_t> index;  // in the whole
  std::vector<std::uint8_t> own_vertex, own_face;
};

Part part_of(const FlatMesh& whole, double side, double reach) {
  Part part;
  std::map<std::size_t, std::size_t> place;
  const auto height = [&](std::size_t v) { return side * (whole.points[v][0] - 0.1); };
  std::vector<Triangle> faces;
  for (const Triangle& face : whole.faces)
    if (std::any_of(face.begin(), face.end(), [&](std::size_t v) { return height(v) >= -reach; }))
      faces.push_back(face);
  for (const Triangle& face : faces)
    for (const std::size_t v : face) place[v] = 0;
  for (auto& [v, local] : place) {
    local = part.index.size();
    part.index.push_back(v);
    part.mesh.points.push_back(whole.points[v]);
    part.own_vertex.push_back(height(v) >= 0);
  }
  for (const Triangle& face : faces) {
    part.mesh.faces.push_back({place[face[0]], place[face[1]], place[face[2]]});
    part.own_face.push_back(height(*std::min_element(face.begin(), face.end())) >= 0);
  }
  return part;
}

class Piece : public testing::TestWithParam<std::string> {};

TEST_P(Piece, ComesOutAsInTheWhole) {
  const FlatMesh shape = noisy_shape(GetParam(), 12000);
  const WholeMesh whole = whole_of(shape);
  const SmoothingParameters parameters;
  Packed<double> expected(shape);
  const SmoothingReport report = smooth(expected.view(), Method::paper, parameters);
  SmoothingReport sum;
  std::size_t far = 0;
  for (const double side : {1.0, -1.0}) {
    Part part = part_of(shape, side, 8 * whole.average_edge_length);
    Packed<double> packed(part.mesh);
    vcg_core::MeshView view = packed.view();
    view.whole = whole;
    view.counted_vertices.data = part.own_vertex.data();
    view.counted_faces.data = part.own_face.data();
    const SmoothingReport of_part = smooth(view, Method::paper, parameters);
    EXPECT_EQ(of_part.average_edge_length, whole.average_edge_length);
    sum.vertices += of_part.vertices;
    sum.faces += of_part.faces;
    sum.border_vertices += of_part.border_vertices;
    sum.fixed_vertices += of_part.fixed_vertices;
    sum.flipped_faces += of_part.flipped_faces;
    sum.volume_before += of_part.volume_before;
    sum.volume_after += of_part.volume_after;
    for (std::size_t v = 0; v < part.index.size(); ++v)
      if (part.own_vertex[v])
        far += (packed.point(v) - expected.point(part.index[v])).Norm() > 1e-4 * whole.average_edge_length;
  }
  // A distance next to the cut-off may come out on its other side, where patches are put together otherwise.
  EXPECT_LE(far, shape.points.size() / 10000);
  EXPECT_EQ(sum.vertices, report.vertices);
  EXPECT_EQ(sum.faces, report.faces);
  EXPECT_EQ(sum.border_vertices, report.border_vertices);
  EXPECT_EQ(sum.fixed_vertices, report.fixed_vertices);
  EXPECT_EQ(sum.flipped_faces, report.flipped_faces);
  EXPECT_NEAR(sum.volume_before, report.volume_before, 1e-12);
  EXPECT_NEAR(sum.volume_after, report.volume_after, 1e-4 * std::abs(report.volume_after));
}

TEST_P(Piece, HasEdgesThatAddUpToTheWhole) {
  const FlatMesh shape = noisy_shape(GetParam(), 3000);
  WholeMesh box = whole_of(shape);
  const double expected = box.average_edge_length;
  box.average_edge_length = 0;
  double length = 0;
  std::size_t edges = 0, vertices = 0;
  for (const double side : {1.0, -1.0}) {
    Part part = part_of(shape, side, 0);
    Packed<double> packed(part.mesh);
    vcg_core::MeshView view = packed.view();
    view.whole = box;
    view.counted_vertices.data = part.own_vertex.data();
    const vcg_core::MeshSummary summary = vcg_core::summarize(view);
    length += summary.average_edge_length * static_cast<double>(summary.edges);
    edges += summary.edges;
    vertices += summary.vertices;
  }
  EXPECT_EQ(vertices, shape.points.size());
  EXPECT_NEAR(length / static_cast<double>(edges), expected, 1e-12 * expected);
}

/// A side of a plane with what lies within `reach` edges of it, as a view that is told of the whole.
struct ToldPart {
  ToldPart(const FlatMesh& shape, double side, double reach, const WholeMesh& whole)
      : part(part_of(shape, side, reach * whole.average_edge_length)), packed(part.mesh) {
    view = packed.view();
    view.whole = whole;
    view.counted_vertices.data = part.own_vertex.data();
    view.counted_faces.data = part.own_face.data();
  }

  Part part;
  Packed<double> packed;
  vcg_core::MeshView view;
};

TEST_P(Piece, ComesOutOfTheGuidedFilterAsInTheWhole) {
  const FlatMesh shape = noisy_shape(GetParam(), 12000);
  const SmoothingParameters parameters = vcg_core::method_info(Method::guided).defaults;
  Packed<double> expected(shape);
  const SmoothingReport report = smooth(expected.view(), Method::guided, parameters);
  WholeMesh whole = whole_of(shape);
  whole.guided.emplace();
  std::vector<std::vector<vcg_core::VertexNoise>> noise;
  for (const double side : {1.0, -1.0}) {
    const vcg_core::NoiseOfPiece of_part = noise_of_piece(ToldPart(shape, side, 24, whole).view);
    vcg_core::GuidedWhole::Testimony& sum = whole.guided->testimony;
    sum.opposed += of_part.testimony.opposed;
    sum.expected += of_part.testimony.expected;
    sum.trusted += of_part.testimony.trusted;
    sum.asked += of_part.testimony.asked;
    noise.push_back(of_part.vertices);
  }
  vcg_core::MeanNoise mean(*whole.guided, whole.average_edge_length);
  for (const std::vector<vcg_core::VertexNoise>& vertices : noise) mean.add(vertices);
  whole.guided->noise = mean.value();
  EXPECT_NEAR(mean.value() / *report.estimated_noise, 1, 1e-6);

  // About, from one part; then by the values of both.
  whole.guided->medians = guided_medians(ToldPart(shape, 1, 16, whole).view, parameters);
  std::vector<vcg_core::ValueCounts> counts;
  for (const double side : {1.0, -1.0}) count_guided_values(ToldPart(shape, side, 16, whole).view, parameters, counts);
  ASSERT_EQ(counts.size(), whole.guided->medians.size());
  for (std::size_t i = 0; i < counts.size(); ++i) whole.guided->medians[i] = counts[i].median();

  std::size_t far = 0;
  for (const double side : {1.0, -1.0}) {
    ToldPart told(shape, side, 40, whole);
    const SmoothingReport of_part = smooth(told.view, Method::guided, parameters);
    EXPECT_NEAR(*of_part.estimated_noise / *report.estimated_noise, 1, 1e-6);
    EXPECT_EQ(of_part.warnings(), report.warnings());
    for (std::size_t v = 0; v < told.part.index.size(); ++v)
      if (told.part.own_vertex[v])
        far += (told.packed.point(v) - expected.point(told.part.index[v])).Norm() > 1e-3 * whole.average_edge_length;
  }
  EXPECT_LE(far, shape.points.size() / 10000);
}

TEST(GuidedMeasures, NeedToBeToldOfTheWhole) {
  const Packed<double> mesh(noisy_shape("torus", 500));
  EXPECT_THROW(vcg_core::noise_of_piece(Packed<double>(mesh).view()), vcg_core::InvalidParameter);
  EXPECT_THROW(vcg_core::guided_medians(Packed<double>(mesh).view(), {}), vcg_core::InvalidParameter);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Piece, testing::Values("torus", "cad_part", "thin_plate", "plane_delaunay"),
                         [](const auto& shape) { return shape.param; });

}  // namespace
