// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that cannot be smoothed: the kind of error, what it says, and that the mesh stays bit for bit as it was.

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/raw_snapshot.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::InvalidMesh;
using Allocator = vcg::tri::Allocator<DoubleMesh>;

/// Expects InvalidMesh with all of `words` in its message and the mesh untouched.
template <class Mesh>
void expect_refused(Mesh& mesh, const std::vector<std::string>& words) {
  const RawSnapshot<Mesh> before(mesh);
  try {
    vcg_core::smooth(mesh, vcg_core::Method::paper);
    ADD_FAILURE() << "no error";
  } catch (const InvalidMesh& error) {
    const std::string message = error.what();
    for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
  }
  EXPECT_TRUE(before.unchanged());
}

TEST(Errors, ShareABaseThatIsARuntimeError) {
  DoubleMesh mesh;
  EXPECT_THROW(vcg_core::smooth(mesh, vcg_core::Method::paper), vcg_core::Error);
  EXPECT_THROW(vcg_core::smooth(mesh, vcg_core::Method::paper), std::runtime_error);
}

TEST(Errors, EmptyMesh) {
  DoubleMesh mesh;
  expect_refused(mesh, {"no faces"});
}

TEST(Errors, PointCloud) {
  DoubleMesh mesh;
  fill(mesh, {octahedron().points, {}});
  expect_refused(mesh, {"no faces"});
}

TEST(Errors, AllFacesDeleted) {
  DoubleMesh mesh;
  fill(mesh, octahedron());
  for (auto& face : mesh.face) Allocator::DeleteFace(mesh, face);
  expect_refused(mesh, {"no faces"});
}

TEST(Errors, NotANumberIsCountedAndTheFirstIsNamed) {
  const double bad_values[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};
  for (const double bad : bad_values)
    for (int axis = 0; axis < 3; ++axis) {
      DoubleMesh mesh;
      fill(mesh, octahedron());
      mesh.vert[4].P()[axis] = bad;
      expect_refused(mesh, {"1 vertex", "vertex 4"});
      mesh.vert[2].P()[2 - axis] = bad;
      mesh.vert[5].P()[axis] = bad;
      expect_refused(mesh, {"3 vertices", "vertex 2"});
    }
}

TEST(Errors, NotANumberInSinglePrecision) {
  FloatMesh mesh;
  fill(mesh, octahedron());
  mesh.vert[1].P()[0] = std::numeric_limits<float>::quiet_NaN();
  expect_refused(mesh, {"1 vertex", "vertex 1"});
}

// The index is that of the caller's mesh.vert, deleted vertices counted; a NaN in a deleted vertex is nobody's
// business.
TEST(Errors, NotANumberBehindDeletedVertices) {
  DoubleMesh mesh;
  fill(mesh, {{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 3}, {0, 3, 4}}});
  Allocator::DeleteVertex(mesh, mesh.vert[2]);
  mesh.vert[2].P()[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(vcg_core::smooth(mesh, vcg_core::Method::paper));
  mesh.vert[3].P()[0] = std::numeric_limits<double>::quiet_NaN();
  expect_refused(mesh, {"1 vertex", "vertex 3"});
}

// A NaN in a vertex of no face counts as well: whoever writes the file next would trip over it.
TEST(Errors, NotANumberInAnIsolatedVertex) {
  FlatMesh shape = octahedron();
  shape.points.emplace_back(0, 0, std::numeric_limits<double>::quiet_NaN());
  DoubleMesh mesh;
  fill(mesh, shape);
  expect_refused(mesh, {"vertex 6"});
}

TEST(Errors, FaceWithoutAVertex) {
  DoubleMesh mesh;
  fill(mesh, octahedron());
  mesh.face[5].V(1) = nullptr;
  expect_refused(mesh, {"face 5", "vertex"});
}

TEST(Errors, FaceWithAVertexBeforeOrBehindTheMesh) {
  DoubleMesh mesh;
  fill(mesh, octahedron());
  DoubleMesh other;
  fill(other, cube());
  mesh.face[3].V(2) = &other.vert[0];
  expect_refused(mesh, {"face 3"});
  mesh.face[3].V(2) = mesh.vert.data() + mesh.vert.size();
  expect_refused(mesh, {"face 3"});
}

TEST(Errors, FaceWithADeletedVertex) {
  DoubleMesh mesh;
  fill(mesh, octahedron());
  Allocator::DeleteVertex(mesh, mesh.vert[5]);
  expect_refused(mesh, {"face 4"});  // the first of those around it
  for (int f = 4; f < 8; ++f) Allocator::DeleteFace(mesh, mesh.face[f]);
  EXPECT_NO_THROW(vcg_core::smooth(mesh, vcg_core::Method::paper));
}

TEST(Errors, AllVerticesInOnePlace) {
  DoubleMesh mesh;
  fill(mesh, transformed(octahedron(), [](const Point&) { return Point(3, 4, 5); }));
  expect_refused(mesh, {"no edge"});
  DoubleMesh at_origin;
  fill(at_origin, transformed(octahedron(), [](const Point&) { return Point(0, 0, 0); }));
  expect_refused(at_origin, {"no edge"});
}

TEST(Errors, OnlyFacesWithRepeatedVertices) {
  DoubleMesh mesh;
  fill(mesh, {octahedron().points, {{0, 0, 1}, {1, 2, 1}, {3, 3, 3}}});
  expect_refused(mesh, {"no edge"});
}

}  // namespace
