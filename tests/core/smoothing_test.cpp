// SPDX-License-Identifier: GPL-3.0-or-later
// The entry point on every kind of vcglib mesh: same result, and nothing but positions touched.

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <mesh_tools/mesh.h>
#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/smoothed.h>

namespace {

using namespace test_support;
using vcg_core::SmoothingParameters;

template <class Mesh>
class SmoothingOf : public testing::Test {};

using Meshes = testing::Types<BareMesh, DoubleMesh, FloatMesh, RichMesh, OcfMesh, mesh_tools::Mesh>;
TYPED_TEST_SUITE(SmoothingOf, Meshes);

/// A mesh's own shape: what is left of `shape` after its coordinates were stored.
template <class Mesh>
FlatMesh as_stored(const FlatMesh& shape) {
  Mesh mesh;
  fill(mesh, shape);
  return flat(mesh);
}

TYPED_TEST(SmoothingOf, GivesWhatDoublePrecisionGives) {
  const FlatMesh shape = as_stored<TypeParam>(potato(2));
  TypeParam mesh;
  fill(mesh, shape);
  const vcg_core::SmoothingReport report = vcg_core::smooth(mesh, vcg_core::Method::paper);
  const FlatMesh expected = smoothed(shape);
  // Of the coordinates, which are below 2, when they are stored; in double the two are the same calculation.
  using Scalar = typename TypeParam::ScalarType;
  constexpr double rounding = std::is_same<Scalar, double>::value ? 0 : 2 * std::numeric_limits<Scalar>::epsilon();
  EXPECT_LE(difference(flat(mesh), expected, 0).largest, rounding);
  EXPECT_EQ(report.moved_vertices, shape.points.size());
}

TYPED_TEST(SmoothingOf, TakesMeshesWithBorders) {
  const FlatMesh shape = as_stored<TypeParam>(height_field(12, [](double x, double y) { return 0.1 * x * y * y; }));
  TypeParam mesh;
  fill(mesh, shape);
  const vcg_core::SmoothingReport report = vcg_core::smooth(mesh, vcg_core::Method::paper);
  EXPECT_EQ(report.border_vertices, 44u);
  EXPECT_EQ(report.fixed_vertices, 44u);
  EXPECT_TRUE(all_finite(flat(mesh)));
}

template <class Mesh>
class SmoothingWithFlagsOf : public testing::Test {};

using MeshesWithFlags = testing::Types<DoubleMesh, FloatMesh, RichMesh, OcfMesh, mesh_tools::Mesh>;
TYPED_TEST_SUITE(SmoothingWithFlagsOf, MeshesWithFlags);

// Deleted vertices and faces lie before, between and behind the others.
TYPED_TEST(SmoothingWithFlagsOf, PassesOverDeletedElements) {
  using Allocator = vcg::tri::Allocator<TypeParam>;
  const FlatMesh shape = as_stored<TypeParam>(potato(1));
  FlatMesh with_more;
  std::vector<std::size_t> place;
  for (const Point& p : shape.points) {
    with_more.points.push_back(p + Point(0.1, 0, 0));  // to be deleted
    place.push_back(with_more.points.size());
    with_more.points.push_back(p);
  }
  with_more.points.emplace_back(100, 0, 0);  // to be deleted
  for (const Triangle& f : shape.faces) {
    with_more.faces.push_back({place[f[0]], place[f[1]], place[f[2]] - 1});  // to be deleted
    with_more.faces.push_back({place[f[0]], place[f[1]], place[f[2]]});
  }
  TypeParam mesh;
  fill(mesh, with_more);
  for (std::size_t f = 0; f < mesh.face.size(); f += 2) Allocator::DeleteFace(mesh, mesh.face[f]);
  for (std::size_t v = 0; v < mesh.vert.size(); v += 2) Allocator::DeleteVertex(mesh, mesh.vert[v]);
  mesh.vert[0].P()[0] = std::numeric_limits<typename TypeParam::ScalarType>::quiet_NaN();

  TypeParam without;
  fill(without, shape);
  vcg_core::smooth(without, vcg_core::Method::paper);
  const vcg_core::SmoothingReport report = vcg_core::smooth(mesh, vcg_core::Method::paper);
  EXPECT_EQ(report.vertices, shape.points.size());
  EXPECT_TRUE(same_bits(flat(mesh), flat(without)));
  EXPECT_TRUE(std::isnan(mesh.vert[0].P()[0]));
  for (std::size_t v = 2; v < mesh.vert.size(); v += 2) {
    EXPECT_TRUE(mesh.vert[v].IsD());
    const FlatMesh as_given = as_stored<TypeParam>({{with_more.points[v]}, {}});
    EXPECT_EQ(Point::Construct(mesh.vert[v].P()), as_given.points[0]);
  }
}

TYPED_TEST(SmoothingWithFlagsOf, ReadsTheSelectionAndLeavesIt) {
  TypeParam mesh;
  fill(mesh, potato(1));
  std::vector<bool> may_move(mesh.vert.size(), false);
  for (std::size_t v = 0; v < mesh.vert.size(); v += 5) {
    mesh.vert[v].SetS();
    may_move[v] = true;
  }
  for (std::size_t f = 0; f < mesh.face.size(); f += 17) {
    mesh.face[f].SetS();
    for (int k = 0; k < 3; ++k) may_move[mesh.face[f].V(k) - mesh.vert.data()] = true;
  }
  SmoothingParameters parameters;
  TypeParam all;
  fill(all, flat(mesh));
  vcg_core::smooth(all, vcg_core::Method::paper, parameters);
  const FlatMesh before = flat(mesh);
  std::vector<int> vertex_flags;
  std::vector<int> face_flags;
  for (const auto& v : mesh.vert) vertex_flags.push_back(v.cFlags());
  for (const auto& f : mesh.face) face_flags.push_back(f.cFlags());

  parameters.selected_only = true;
  vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
  // The others are neighbours as ever, so the selected ones move as if all did.
  const FlatMesh after = flat(mesh);
  const FlatMesh after_all = flat(all);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    EXPECT_EQ(after.points[v], may_move[v] ? after_all.points[v] : before.points[v]) << v;
    EXPECT_EQ(mesh.vert[v].cFlags(), vertex_flags[v]);
  }
  for (std::size_t f = 0; f < mesh.face.size(); ++f) EXPECT_EQ(mesh.face[f].cFlags(), face_flags[f]);
}

/// The bytes of all vertices, with the positions blanked out.
template <class Mesh>
std::vector<unsigned char> bytes_but_positions(Mesh& mesh) {
  std::vector<unsigned char> result;
  for (auto& vertex : mesh.vert) {
    unsigned char bytes[sizeof(vertex)];
    std::memcpy(bytes, static_cast<const void*>(&vertex), sizeof(vertex));
    const auto* const position = reinterpret_cast<const unsigned char*>(&vertex.P());
    const auto offset = position - reinterpret_cast<const unsigned char*>(&vertex);
    std::fill_n(bytes + offset, sizeof(vertex.P()), static_cast<unsigned char>(0));
    result.insert(result.end(), bytes, bytes + sizeof(vertex));
  }
  return result;
}

TEST(Smoothing, TouchesNothingButPositions) {
  RichMesh mesh;
  fill(mesh, potato(2));
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    mesh.vert[v].C() = vcg::Color4b(v % 251, v % 13, 7, 255);
    mesh.vert[v].Q() = 0.1 * static_cast<double>(v);
    mesh.vert[v].N() = Point(1, 2, 3);
    mesh.vert[v].T().U() = 0.25F;
  }
  mesh.bbox.Add(Point(9, 9, 9));
  const auto vertices = bytes_but_positions(mesh);
  std::vector<unsigned char> faces(mesh.face.size() * sizeof(mesh.face[0]));
  std::memcpy(faces.data(), static_cast<const void*>(mesh.face.data()), faces.size());
  vcg_core::smooth(mesh, vcg_core::Method::paper);
  EXPECT_EQ(vertices, bytes_but_positions(mesh));
  EXPECT_EQ(std::memcmp(faces.data(), static_cast<const void*>(mesh.face.data()), faces.size()), 0);
  EXPECT_EQ(mesh.bbox.max, Point(9, 9, 9));
}

TEST(Smoothing, WorksWithOptionalComponentsEnabled) {
  OcfMesh mesh;
  fill(mesh, potato(1));
  OcfMesh plain;
  fill(plain, potato(1));
  mesh.vert.EnableMark();
  mesh.vert.EnableVFAdjacency();
  mesh.vert.EnableTexCoord();
  mesh.face.EnableFFAdjacency();
  mesh.face.EnableQuality();
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) mesh.vert[v].T().U() = static_cast<float>(v);
  vcg_core::smooth(mesh, vcg_core::Method::paper);
  vcg_core::smooth(plain, vcg_core::Method::paper);
  EXPECT_TRUE(same_bits(flat(mesh), flat(plain)));
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) EXPECT_EQ(mesh.vert[v].T().U(), static_cast<float>(v));
}

// Twice the same call on the same input: nothing is kept from one to the next.
TEST(Smoothing, IsRepeatable) { EXPECT_TRUE(same_bits(smoothed(potato(3)), smoothed(potato(3)))); }

}  // namespace
