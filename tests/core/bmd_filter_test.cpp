// SPDX-License-Identifier: GPL-3.0-or-later
// Bilateral mesh denoising against section 3's formula, and what it does to a sphere and to thin parts.

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>
#include <support/smoothed_by.h>

namespace {

using namespace test_support;
using vcg_core::GaussianForm;
using vcg_core::Method;
using vcg_core::SmoothingParameters;

/// Section 3's formula for every vertex, over all vertices that belong to a face.
FlatMesh naive_bmd(const FlatMesh& mesh, const SmoothingParameters& p) {
  const NaiveReference geometry(mesh);  // for normals, borders and |e|
  const double e = geometry.average_edge_length();
  const double factor = p.gaussian == GaussianForm::printed ? 1 : 2;
  const auto weight = [&](double x, double sigma) { return std::exp(-x * x / (factor * sigma * sigma * e * e)); };
  std::vector<bool> has_face(mesh.points.size(), false);
  for (const Triangle& f : mesh.faces)
    for (const std::size_t v : f) has_face[v] = true;
  FlatMesh result = mesh;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!has_face[i] || (p.boundary == vcg_core::Boundary::fixed && geometry.on_border(i))) continue;
    double sum = 0, weights = 0;
    for (std::size_t j = 0; j < mesh.points.size(); ++j) {
      const Point way = mesh.points[i] - mesh.points[j];
      if (!has_face[j] || !(way.Norm() < p.rho * p.sigma_c * e)) continue;
      const double height = geometry.normal(i) * way;
      const double w = weight(way.Norm(), p.sigma_c) * weight(height, p.sigma_s);
      sum += w * height;
      weights += w;
    }
    result.points[i] -= geometry.normal(i) * (sum / weights);
  }
  return result;
}

struct NamedParameters {
  const char* name;
  SmoothingParameters values;
};

class BmdFilter : public testing::TestWithParam<NamedParameters> {};

TEST_P(BmdFilter, IsTheFormula) {
  for (const char* shape : {"cad_part", "thin_sheets", "graded_cube"}) {
    FlatMesh mesh = noisy_shape(shape, 700);
    mesh.points.push_back(mesh.points[5] + Point(0.001, 0.002, 0.001));  // without a face: nobody's neighbour
    const double e = average_edge_length(mesh);
    const FlatMesh result = smoothed_by(Method::bmd, mesh, GetParam().values).mesh;
    EXPECT_LE(difference(result, naive_bmd(mesh, GetParam().values), 0).largest, 1e-12 * e) << shape;
    EXPECT_GT(difference(result, mesh, 0.01 * e).beyond_tolerance, mesh.points.size() / 3) << shape;
  }
}

SmoothingParameters with(double sigma_c, double sigma_s, double rho, GaussianForm gaussian,
                         vcg_core::Boundary boundary) {
  SmoothingParameters p;
  p.sigma_c = sigma_c;
  p.sigma_s = sigma_s;
  p.rho = rho;
  p.gaussian = gaussian;
  p.boundary = boundary;
  return p;
}

INSTANTIATE_TEST_SUITE_P(Parameters, BmdFilter,
                         testing::Values(NamedParameters{"table_1", {}},
                                         NamedParameters{"wide_printed_free", with(3, 0.5, 1.5, GaussianForm::printed,
                                                                                   vcg_core::Boundary::free)},
                                         NamedParameters{"narrow", with(0.5, 2, 3, GaussianForm::standard_deviation,
                                                                        vcg_core::Boundary::fixed)}),
                         [](const auto& test) { return std::string(test.param.name); });

/// d_i on a sphere of radius 1 that is covered evenly: a neighbour at distance x lies x^2 / 2 below the tangent plane,
/// and the area within x is proportional to x^2.
double offset_on_unit_sphere(double sigma_c, double sigma_s, double rho) {
  constexpr int steps = 100000;
  double sum = 0, weights = 0;
  for (int k = 0; k < steps; ++k) {
    const double x_squared = rho * rho * (k + 0.5) / steps;
    const double height = x_squared / 2;
    const double w = std::exp(-x_squared / (2 * sigma_c * sigma_c) - height * height / (2 * sigma_s * sigma_s));
    sum += w * height;
    weights += w;
  }
  return sum / weights;
}

TEST(BmdFilterOnASphere, ShrinksItByWhatTheFormulaGives) {
  constexpr double sigma_c = 0.2, sigma_s = 0.02;
  const double expected = offset_on_unit_sphere(sigma_c, sigma_s, 2 * sigma_c);
  ASSERT_GT(expected, 0.005);
  // What is left on the fine ones: the icosphere's vertices do not cover it quite evenly.
  for (const auto& [level, tolerance] : {std::pair(3, 0.015), std::pair(4, 0.001), std::pair(5, 0.001)}) {
    const FlatMesh sphere = icosphere(level);
    SmoothingParameters p;
    p.sigma_c = sigma_c / average_edge_length(sphere);
    p.sigma_s = sigma_s / average_edge_length(sphere);
    const FlatMesh result = smoothed_by(Method::bmd, sphere, p).mesh;
    double radius = 0;
    for (const Point& point : result.points) radius += point.Norm() / static_cast<double>(result.points.size());
    EXPECT_NEAR((1 - radius) / expected, 1, tolerance) << "level " << level;
  }
}

// Two sheets that face away from each other, an edge length apart: neighbours in space only.
TEST(BmdFilterOnThinParts, DrawsThemTogetherWhereThePaperDoesNot) {
  FlatMesh mesh = grid(21);
  const double e = average_edge_length(mesh);
  FlatMesh below = transformed(mesh, [e](const Point& p) { return Point(p[0], p[1], -e); });
  for (Triangle& f : below.faces) std::swap(f[1], f[2]);
  append(mesh, below);
  constexpr std::size_t middle = 10 * 21 + 10;
  EXPECT_LT(smoothed_by(Method::bmd, mesh).mesh.points[middle][2], -0.2 * e);
  EXPECT_NEAR(smoothed_by(Method::paper, mesh).mesh.points[middle][2], 0, 1e-12);
}

}  // namespace
