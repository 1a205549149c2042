// SPDX-License-Identifier: GPL-3.0-or-later
// What is told to stay stays bit for bit.

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>

namespace {

using namespace test_support;
using vcg_core::SmoothingParameters;

class FixedVertices : public testing::TestWithParam<SmoothingPath> {
 protected:
  const FlatMesh mesh_ = noisy_shape("plane_delaunay", 800, 0.3);
};

TEST_P(FixedVertices, BorderStaysAndAllElseMoves) {
  SmoothingParameters parameters = GetParam().parameters;
  parameters.iterations = 2;
  const FlatMesh result = smoothed(mesh_, parameters);
  const NaiveReference reference(mesh_);
  std::size_t border = 0;
  for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
    border += reference.on_border(v);
    EXPECT_EQ(result.points[v] == mesh_.points[v], reference.on_border(v)) << v;
  }
  EXPECT_GT(border, 10u);
}

TEST_P(FixedVertices, FreeBorderMoves) {
  SmoothingParameters parameters = GetParam().parameters;
  parameters.boundary = vcg_core::Boundary::free;
  const FlatMesh result = smoothed(mesh_, parameters);
  const NaiveReference reference(mesh_);
  for (std::size_t v = 0; v < mesh_.points.size(); ++v) EXPECT_TRUE(result.points[v] != mesh_.points[v]) << v;
}

// In one pass the border serves as neighbours, moving or not: inner vertices do not see the difference.
TEST_P(FixedVertices, BorderCountsAsNeighbors) {
  SmoothingParameters parameters = GetParam().parameters;
  const FlatMesh fixed = smoothed(mesh_, parameters);
  parameters.boundary = vcg_core::Boundary::free;
  FlatMesh free = smoothed(mesh_, parameters);
  const NaiveReference reference(mesh_);
  for (std::size_t v = 0; v < mesh_.points.size(); ++v)
    if (reference.on_border(v)) free.points[v] = mesh_.points[v];
  EXPECT_TRUE(same_bits(fixed, free));
}

// The same of what is not selected.
TEST_P(FixedVertices, UnselectedOnesCountAsNeighbors) {
  DoubleMesh mesh;
  fill(mesh, mesh_);
  for (std::size_t v = 0; v < mesh.vert.size(); v += 7) mesh.vert[v].SetS();
  SmoothingParameters parameters = GetParam().parameters;
  FlatMesh expected = smoothed(mesh_, parameters);
  for (std::size_t v = 0; v < mesh_.points.size(); ++v)
    if (v % 7 != 0) expected.points[v] = mesh_.points[v];
  parameters.selected_only = true;
  vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
  EXPECT_TRUE(same_bits(flat(mesh), expected));
}

TEST_P(FixedVertices, UnselectedOnesStayThroughAllPasses) {
  DoubleMesh mesh;
  fill(mesh, mesh_);
  for (std::size_t v = 0; v < mesh.vert.size(); v += 3) mesh.vert[v].SetS();
  SmoothingParameters parameters = GetParam().parameters;
  parameters.selected_only = true;
  parameters.boundary = vcg_core::Boundary::free;
  parameters.iterations = 3;
  vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) EXPECT_EQ(mesh.vert[v].P() != mesh_.points[v], v % 3 == 0) << v;
}

// Selected border vertices are held by the border all the same.
TEST_P(FixedVertices, SelectionDoesNotFreeTheBorder) {
  DoubleMesh mesh;
  fill(mesh, mesh_);
  for (auto& face : mesh.face) face.SetS();
  DoubleMesh without_selection;
  fill(without_selection, mesh_);
  SmoothingParameters parameters = GetParam().parameters;
  vcg_core::smooth(without_selection, vcg_core::Method::paper, parameters);
  parameters.selected_only = true;
  vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
  EXPECT_TRUE(same_bits(flat(mesh), flat(without_selection)));
}

// A selection that is there and not asked for changes nothing.
TEST_P(FixedVertices, SelectionIsIgnoredUnlessAskedFor) {
  DoubleMesh mesh;
  fill(mesh, mesh_);
  mesh.vert[5].SetS();
  vcg_core::smooth(mesh, vcg_core::Method::paper, GetParam().parameters);
  EXPECT_TRUE(same_bits(flat(mesh), smoothed(mesh_, GetParam().parameters)));
}

INSTANTIATE_TEST_SUITE_P(Paths, FixedVertices, testing::ValuesIn(smoothing_paths()), name_of_path);

}  // namespace
