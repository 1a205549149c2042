// SPDX-License-Identifier: GPL-3.0-or-later
// vcglib's Laplacian, HC and Taubin's smoothing as this library calls them: steps by hand, borders, what is kept out.

#include <set>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/smoothed_by.h>

namespace {

using namespace test_support;
using vcg_core::Boundary;
using vcg_core::Method;
using vcg_core::SmoothingParameters;

SmoothingParameters steps(int iterations, Boundary boundary = Boundary::fixed) {
  SmoothingParameters p;
  p.iterations = iterations;
  p.boundary = boundary;
  return p;
}

/// A hub, vertex 0, and six vertices around it, of which the hub sees the mean.
FlatMesh fan() {
  return {{{0.1, 0.2, 1}, {2, 0, 0}, {1, 2, 0.5}, {-1, 2, 0}, {-2, 0, 0.25}, {-1, -2, 0}, {1, -2, 0.75}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}}};
}
const Point rim_mean(0, 0, 0.25);

void expect_near(const Point& a, const Point& b) {
  EXPECT_LE((a - b).Norm(), 1e-14) << b[0] << " " << b[1] << " " << b[2];
}

TEST(LaplacianFilter, TwoStepsOnAFanByHand) {
  const FlatMesh mesh = fan();
  const Point one = (mesh.points[0] + rim_mean * 12) / 13;
  expect_near(smoothed_by(Method::laplacian, mesh, steps(1)).mesh.points[0], one);
  const SmoothedBy two = smoothed_by(Method::laplacian, mesh, steps(2));
  expect_near(two.mesh.points[0], (one + rim_mean * 12) / 13);
  EXPECT_EQ(two.report.moved_vertices, 1u);
  EXPECT_EQ(two.report.fixed_vertices, 6u);
}

TEST(TaubinFilter, AStepOnAFanByHand) {
  const Point shrunk = fan().points[0] + (rim_mean - fan().points[0]) * static_cast<double>(0.6307f);
  const Point expected = shrunk + (rim_mean - shrunk) * static_cast<double>(-0.6732f);
  expect_near(smoothed_by(Method::taubin, fan(), steps(1)).mesh.points[0], expected);
}

// vcglib adds the neighbours' mean displacement; the article (hc_filter_test.cpp) subtracts it.
TEST(HcVcglibFilter, AStepOnAFanByHand) {
  const FlatMesh mesh = fan();
  const std::vector<Point>& p = mesh.points;
  const Point step_of_hub = rim_mean - p[0];
  Point mean_step_of_rim(0, 0, 0);
  for (std::size_t k = 0; k < 6; ++k) {
    const Point& before = p[1 + (k + 5) % 6];
    const Point& after = p[1 + (k + 1) % 6];
    mean_step_of_rim += ((before + after + p[0]) / 3 - p[1 + k]) / 6;
  }
  expect_near(smoothed_by(Method::hc_vcglib, mesh, steps(1)).mesh.points[0],
              p[0] + (step_of_hub + mean_step_of_rim) * 0.5);
}

TEST(LaplacianFilter, FollowsTheSameRuleAlongAFreeBorder) {
  const FlatMesh mesh = fan();
  const FlatMesh result = smoothed_by(Method::laplacian, mesh, steps(1, Boundary::free)).mesh;
  expect_near(result.points[2], (mesh.points[2] + (mesh.points[1] + mesh.points[3]) * 2) / 5);
}

TEST(TaubinFilter, FollowsTheSameRuleAlongAFreeBorder) {
  const FlatMesh mesh = fan();
  FlatMesh expected = mesh;
  for (const double length : {static_cast<double>(0.6307f), static_cast<double>(-0.6732f)}) {
    const FlatMesh before = expected;
    for (std::size_t k = 0; k < 6; ++k) {
      const Point mean = (before.points[1 + (k + 5) % 6] + before.points[1 + (k + 1) % 6]) / 2;
      expected.points[1 + k] += (mean - before.points[1 + k]) * length;
    }
  }
  const FlatMesh result = smoothed_by(Method::taubin, mesh, steps(1, Boundary::free)).mesh;
  for (std::size_t k = 1; k <= 6; ++k) expect_near(result.points[k], expected.points[k]);
}

TEST(VcglibFilters, StepsAddUp) {
  const FlatMesh mesh = potato(2);
  for (const Method method : {Method::laplacian, Method::hc_vcglib, Method::taubin}) {
    FlatMesh one_by_one = mesh;
    for (int k = 0; k < 5; ++k) one_by_one = smoothed_by(method, one_by_one, steps(1)).mesh;
    const double largest = difference(one_by_one, smoothed_by(method, mesh, steps(5)).mesh, 0).largest;
    EXPECT_LE(largest, 1e-13) << vcg_core::method_name(method);
  }
}

TEST(LaplacianFilter, IsTheMeanOfNeighboursOnAClosedSurface) {
  const FlatMesh mesh = potato(2);
  std::vector<std::set<std::size_t>> neighbors(mesh.points.size());
  for (const Triangle& f : mesh.faces)
    for (int k = 0; k < 3; ++k) neighbors[f[k]].insert({f[(k + 1) % 3], f[(k + 2) % 3]});
  const FlatMesh result = smoothed_by(Method::laplacian, mesh, steps(1)).mesh;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    Point sum = mesh.points[i];
    for (const std::size_t j : neighbors[i]) sum += mesh.points[j] * 2;
    expect_near(result.points[i], sum / (2.0 * static_cast<double>(neighbors[i].size()) + 1));
  }
}

// vcglib alone divides by zero at the isolated vertex and counts a vertex as its own neighbour in the broken face.
TEST(VcglibFilters, KeepOutWhatVcglibCannotTake) {
  for (const Method method : {Method::laplacian, Method::hc_vcglib, Method::taubin}) {
    const FlatMesh clean = potato(1);
    FlatMesh broken = clean;
    broken.points.emplace_back(5, 5, 5);
    broken.faces.push_back({0, 0, 1});
    const SmoothedBy result = smoothed_by(method, broken, steps(3));
    const FlatMesh expected = smoothed_by(method, clean, steps(3)).mesh;
    for (std::size_t i = 0; i < clean.points.size(); ++i) expect_near(result.mesh.points[i], expected.points[i]);
    EXPECT_EQ(result.mesh.points.back(), broken.points.back());
    EXPECT_EQ(result.report.skipped_vertices.isolated, 1u);
    EXPECT_TRUE(all_finite(result.mesh));
  }
}

}  // namespace
