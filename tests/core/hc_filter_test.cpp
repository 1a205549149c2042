// SPDX-License-Identifier: GPL-3.0-or-later
// Improved Laplacian smoothing (Vollmer, Mencl, Mueller 1999) against the article's own loop, and what it promises.

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/noisy_shapes.h>
#include <support/smoothed_by.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::Boundary;
using vcg_core::Method;
using vcg_core::SmoothingParameters;

using Points = std::vector<Point>;
using Neighbors = std::vector<std::set<std::size_t>>;

SmoothingParameters steps(int iterations, Boundary boundary = Boundary::fixed) {
  SmoothingParameters p;
  p.iterations = iterations;
  p.boundary = boundary;
  return p;
}

Neighbors all_neighbors(const FlatMesh& mesh) {
  Neighbors adj(mesh.points.size());
  for (const Triangle& f : mesh.faces) {
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
    for (int k = 0; k < 3; ++k) adj[f[k]].insert({f[(k + 1) % 3], f[(k + 2) % 3]});
  }
  return adj;
}

Point mean(const std::set<std::size_t>& of, const Points& values) {
  Point sum(0, 0, 0);
  for (const std::size_t j : of) sum += values[j];
  return sum / static_cast<double>(of.size());
}

/// The article's loop with its names, for the vertices that `variable` holds.
Points by_the_article(const FlatMesh& mesh, const Neighbors& adj, const std::set<std::size_t>& variable,
                      int iterations) {
  const double alpha = 0;
  const double beta = 0.5;
  const Points& o = mesh.points;
  Points p = o;
  for (int step = 0; step < iterations; ++step) {
    const Points q = p;
    Points b(p.size(), Point(0, 0, 0));
    for (const std::size_t i : variable) {
      p[i] = mean(adj[i], q);
      b[i] = p[i] - (o[i] * alpha + q[i] * (1 - alpha));
    }
    for (const std::size_t i : variable) p[i] -= b[i] * beta + mean(adj[i], b) * (1 - beta);
  }
  return p;
}

void expect_near(const Points& result, const Points& expected, double tolerance = 1e-13) {
  ASSERT_EQ(result.size(), expected.size());
  for (std::size_t i = 0; i < result.size(); ++i) EXPECT_LE((result[i] - expected[i]).Norm(), tolerance) << i;
}

std::set<std::size_t> all_vertices(const FlatMesh& mesh) {
  std::set<std::size_t> all;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) all.insert(i);
  return all;
}

constexpr std::size_t side = 7;

FlatMesh bumpy_field() {
  return height_field(side, [](double x, double y) { return 0.3 * std::sin(9 * x + 2 * y) * std::cos(7 * y); });
}

bool on_edge_of_field(std::size_t v) {
  return v % side == 0 || v % side == side - 1 || v / side == 0 || v / side == side - 1;
}

std::set<std::size_t> inside_of_field() {
  std::set<std::size_t> inside;
  for (std::size_t v = 0; v < side * side; ++v)
    if (!on_edge_of_field(v)) inside.insert(v);
  return inside;
}

TEST(HcFilter, IsTheArticlesLoopOnAClosedSurface) {
  const FlatMesh mesh = noisy_shape("sphere", 300, 0.3);
  const Points expected = by_the_article(mesh, all_neighbors(mesh), all_vertices(mesh), 20);
  expect_near(smoothed_by(Method::hc, mesh).mesh.points, expected);
}

TEST(HcFilter, IsTheArticlesLoopInsideAFixedBorder) {
  const FlatMesh mesh = bumpy_field();
  const vcg_core::SmoothingReport report = smoothed_by(Method::hc, mesh, steps(5)).report;
  EXPECT_EQ(report.fixed_vertices, 4 * (side - 1));
  expect_near(smoothed_by(Method::hc, mesh, steps(5)).mesh.points,
              by_the_article(mesh, all_neighbors(mesh), inside_of_field(), 5));
}

TEST(HcFilter, HasOnlyNeighborsAlongTheBorderOnAFreeOne) {
  const FlatMesh mesh = bumpy_field();
  Neighbors adj = all_neighbors(mesh);
  for (std::size_t v = 0; v < adj.size(); ++v) {
    if (!on_edge_of_field(v)) continue;
    std::set<std::size_t> along;
    for (const std::size_t j : adj[v])  // two on the edge of the grid share a side of it, but for the cut corners
      if (on_edge_of_field(j) && (j % side == v % side || j / side == v / side)) along.insert(j);
    ASSERT_EQ(along.size(), 2u);
    adj[v] = along;
  }
  expect_near(smoothed_by(Method::hc, mesh, steps(5, Boundary::free)).mesh.points,
              by_the_article(mesh, adj, all_vertices(mesh), 5));
}

TEST(HcFilter, MovesSelectedVerticesAmongTheOthers) {
  const FlatMesh mesh = potato(2);
  const std::set<std::size_t> variable{0, 1, 5, 17, 18, 40, 41, 100};
  DoubleMesh selected;
  fill(selected, mesh);
  for (const std::size_t v : variable) selected.vert[v].SetS();
  SmoothingParameters parameters = steps(4);
  parameters.selected_only = true;
  vcg_core::smooth(selected, Method::hc, parameters);
  expect_near(flat(selected).points, by_the_article(mesh, all_neighbors(mesh), variable, 4));
}

// A third face at an edge is no second edge, and neither a face with a repeated vertex nor an isolated vertex counts.
TEST(HcFilter, CountsEachNeighborOnceOnBrokenMeshes) {
  FlatMesh mesh = potato(1);
  const std::size_t fin = mesh.points.size();
  mesh.points.emplace_back(2, 2, 2);
  mesh.faces.push_back({mesh.faces[0][0], mesh.faces[0][1], fin});
  mesh.faces.push_back({0, 0, 1});
  mesh.points.emplace_back(5, 5, 5);
  std::set<std::size_t> variable = all_vertices(mesh);
  for (const std::size_t held : {mesh.faces[0][0], mesh.faces[0][1], fin, fin + 1}) variable.erase(held);
  const SmoothedBy result = smoothed_by(Method::hc, mesh, steps(3));
  expect_near(result.mesh.points, by_the_article(mesh, all_neighbors(mesh), variable, 3));
  EXPECT_EQ(result.report.skipped_vertices.isolated, 1u);

  // Free, the fin's corners have neighbours along its two border edges only: the edge of three faces is no border.
  Neighbors adj = all_neighbors(mesh);
  const std::size_t a = mesh.faces[0][0];
  const std::size_t b = mesh.faces[0][1];
  adj[a] = adj[b] = {fin};
  adj[fin] = {a, b};
  variable.insert({a, b, fin});
  expect_near(smoothed_by(Method::hc, mesh, steps(3, Boundary::free)).mesh.points,
              by_the_article(mesh, adj, variable, 3));
}

// The two steps differ in one sign, so that together they make the plain step to the mean of the neighbours.
TEST(HcFilter, AddsUpWithVcglibsToTheLaplacianStep) {
  const FlatMesh mesh = potato(2);
  const Neighbors adj = all_neighbors(mesh);
  const Points article = smoothed_by(Method::hc, mesh, steps(1)).mesh.points;
  const Points vcglib = smoothed_by(Method::hc_vcglib, mesh, steps(1)).mesh.points;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    EXPECT_LE((article[i] + vcglib[i] - mesh.points[i] - mean(adj[i], mesh.points)).Norm(), 1e-14) << i;
}

// What the article set out to do. A Laplacian step of a mean ring radius h shrinks a sphere by about h^2 / 2 of its
// radius; pushed back, all that is left is of the order of h^4.
TEST(HcFilter, KeepsASphereWhereTheLaplacianShrinksIt) {
  const auto shrinkage = [](Method method, int levels) {
    const vcg_core::SmoothingReport report = smoothed_by(method, icosphere(levels)).report;
    return 1 - report.volume_after / report.volume_before;
  };
  EXPECT_GT(shrinkage(Method::laplacian, 3), 0.1);
  EXPECT_LT(std::abs(shrinkage(Method::hc, 3)), 0.02 * shrinkage(Method::laplacian, 3));
  EXPECT_GT(shrinkage(Method::hc_vcglib, 3), shrinkage(Method::laplacian, 3));
  EXPECT_LT(std::abs(shrinkage(Method::hc, 4)), std::abs(shrinkage(Method::hc, 3)) / 8);
}

TEST(HcFilter, KeepsAPlaneFlat) {
  const FlatMesh result =
      smoothed_by(Method::hc, noisy_shape("plane_random_diagonals", 400, 0), steps(20, Boundary::free)).mesh;
  for (const Point& p : result.points) EXPECT_EQ(p[2], result.points[0][2]);
}

}  // namespace
