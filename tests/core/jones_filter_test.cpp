// SPDX-License-Identifier: GPL-3.0-or-later
// Jones's filter against its definition, and on a plane, a box and a mesh with gaps.

#include <cmath>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>
#include <support/smoothed_by.h>

namespace {

using namespace test_support;
using vcg_core::Boundary;
using vcg_core::Method;
using vcg_core::SmoothingParameters;

Point cross(const FlatMesh& mesh, const Triangle& f) {
  const Point& a = mesh.points[f[0]];
  return (mesh.points[f[1]] - a) ^ (mesh.points[f[2]] - a);
}

Point centroid(const FlatMesh& mesh, const Triangle& f) {
  return (mesh.points[f[0]] + mesh.points[f[1]] + mesh.points[f[2]]) / 3;
}

double gaussian(double x, double sigma) { return std::exp(-x * x / (2 * sigma * sigma)); }

/// The definition in the header of the filter, every vertex against every face.
FlatMesh naive_jones(const FlatMesh& mesh, const SmoothingParameters& p) {
  const NaiveReference geometry(mesh);  // for borders and |e|
  const double e = geometry.average_edge_length();
  FlatMesh copy = mesh;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    Point sum(0, 0, 0);
    double weights = 0;
    for (const Triangle& f : mesh.faces) {
      const double distance = (centroid(mesh, f) - mesh.points[i]).Norm();
      if (!(distance < p.rho * p.sigma_c / 2 * e)) continue;
      const double w = cross(mesh, f).Norm() * gaussian(distance, p.sigma_c / 2 * e);
      sum += centroid(mesh, f) * w;
      weights += w;
    }
    if (weights > 0) copy.points[i] = sum / weights;
  }
  FlatMesh result = mesh;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (p.boundary == Boundary::fixed && geometry.on_border(i)) continue;
    Point sum(0, 0, 0);
    double weights = 0;
    for (const Triangle& f : mesh.faces) {
      const Point c = centroid(mesh, f);
      const double distance = (c - mesh.points[i]).Norm();
      if (!(distance < p.rho * p.sigma_c * e)) continue;
      const Point n = cross(copy, f) / cross(copy, f).Norm();
      const Point prediction = mesh.points[i] - n * (n * (mesh.points[i] - c));
      const double w = cross(mesh, f).Norm() * gaussian(distance, p.sigma_c * e) *
                       gaussian((prediction - mesh.points[i]).Norm(), p.sigma_s * e);
      sum += prediction * w;
      weights += w;
    }
    if (weights > 0) result.points[i] = sum / weights;
  }
  return result;
}

TEST(JonesFilter, IsItsDefinition) {
  SmoothingParameters wide;
  wide.sigma_c = 3;
  wide.sigma_s = 0.5;
  wide.rho = 1.5;
  wide.boundary = Boundary::free;
  for (const SmoothingParameters& p : {SmoothingParameters(), wide})
    for (const char* shape : {"cad_part", "thin_sheets", "graded_cube"}) {
      const FlatMesh mesh = noisy_shape(shape, 700);
      const double e = average_edge_length(mesh);
      const FlatMesh result = smoothed_by(Method::jones, mesh, p).mesh;
      EXPECT_LE(difference(result, naive_jones(mesh, p), 0).largest, 1e-11 * e) << shape;
      EXPECT_GT(difference(result, mesh, 0.01 * e).beyond_tolerance, mesh.points.size() / 3) << shape;
    }
}

TEST(JonesFilter, LeavesAPlaneAsItIs) {
  // Uneven triangles in a plane that is not along the axes.
  FlatMesh mesh = transformed(grid(25), [](const Point& p) {
    const double x = p[0] + 0.01 * std::sin(40 * p[1]), y = p[1] + 0.01 * std::cos(50 * p[0]);
    return Point(x, y, 0.3 * x - 0.7 * y + 2);
  });
  SmoothingParameters p;
  p.boundary = Boundary::free;
  EXPECT_LE(difference(smoothed_by(Method::jones, mesh, p).mesh, mesh, 0).largest, 1e-13);
}

TEST(JonesFilter, LeavesABoxAsItIsAwayFromItsEdges) {
  const FlatMesh box = noisy_shape("cube", 15000, 0);
  const double e = average_edge_length(box);
  const FlatMesh result = smoothed_by(Method::jones, box).mesh;
  Point low(1e9, 1e9, 1e9), high(-1e9, -1e9, -1e9);
  for (const Point& p : box.points)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  // A face's normal is off where its copy sees around an edge: 2 e and its own size; a vertex sees 4 e far.
  std::size_t inside = 0;
  for (std::size_t i = 0; i < box.points.size(); ++i) {
    int near_sides = 0;
    for (int k = 0; k < 3; ++k) near_sides += box.points[i][k] < low[k] + 8 * e || box.points[i][k] > high[k] - 8 * e;
    const double moved = (result.points[i] - box.points[i]).Norm();
    // At an edge the two sides pull: at most as far as the mean of heights that count, below sigma_s = e.
    EXPECT_LT(moved, 0.6 * e) << "vertex " << i;
    if (near_sides > 1) continue;
    ++inside;
    EXPECT_LE(moved, 1e-12) << "vertex " << i;
  }
  EXPECT_GT(inside, box.points.size() / 3);
}

// A fine sheet and one huge triangle: no centroid within the cut-off of the triangle's corners.
TEST(JonesFilter, CountsVerticesWithNothingNearAndLeavesThem) {
  FlatMesh mesh = height_field(20, [](double x, double y) { return 0.02 * std::sin(20 * x) * std::cos(30 * y); });
  const std::size_t first = mesh.points.size();
  append(mesh, {{{50, 0, 0}, {150, 0, 0}, {50, 100, 0}}, {{0, 1, 2}}});
  SmoothingParameters p;
  p.boundary = Boundary::free;
  const SmoothedBy result = smoothed_by(Method::jones, mesh, p);
  EXPECT_EQ(result.report.skipped_vertices.empty_neighbourhood, 3u);
  EXPECT_EQ(result.report.skipped_vertices.total(), 3u);
  EXPECT_EQ(result.report.moved_vertices, first);
  for (std::size_t i = first; i < mesh.points.size(); ++i) EXPECT_EQ(result.mesh.points[i], mesh.points[i]);
  bool told = false;
  for (const std::string& sentence : result.report.warnings())
    told = told || sentence.rfind("3 vertices have nothing within the cut-off", 0) == 0;
  EXPECT_TRUE(told);
}

}  // namespace
