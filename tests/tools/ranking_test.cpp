// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper claims of its figure 9, on the CAD part: of Table 1's six methods its filter keeps sharp edges best.

#include <map>

#include <gtest/gtest.h>

#include <mesh_tools/measure.h>
#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>
#include <vcg_core/smoothing.h>

namespace {

using vcg_core::Method;

/// Figures of a method with its defaults on the CAD part with noise along the normals.
mesh_tools::Measurement figures_of(Method method, double noise, const mesh_tools::Mesh& clean) {
  mesh_tools::Mesh mesh = mesh_tools::make_shape("cad_part", 6500);
  mesh_tools::add_noise(mesh, noise, 1, mesh_tools::NoiseDirection::normal);
  vcg_core::smooth(mesh, method, vcg_core::method_info(method).defaults);
  return mesh_tools::measure(mesh, clean);
}

/// The same for Table 1's six methods.
std::map<Method, mesh_tools::Measurement> figures_at(double noise) {
  const mesh_tools::Mesh clean = mesh_tools::make_shape("cad_part", 6500);
  std::map<Method, mesh_tools::Measurement> figures;
  for (const Method method : {Method::laplacian, Method::hc, Method::taubin, Method::jones, Method::bmd, Method::paper})
    figures.emplace(method, figures_of(method, noise, clean));
  return figures;
}

class Ranking : public testing::TestWithParam<double> {};

// The next best, Jones's filter, has 1.5 to 2 times the error; the benchmark in which these filters were compared by
// others gives the same order.
TEST_P(Ranking, ThePapersFilterKeepsSharpEdgesBest) {
  auto figures = figures_at(GetParam());
  const double best = figures[Method::paper].sharp_normal_error.mean;
  for (const auto& [method, measured] : figures) {
    if (method == Method::paper) continue;
    EXPECT_GT(measured.sharp_normal_error.mean, 1.3 * best) << vcg_core::method_name(method);
    EXPECT_GT(measured.normal_error.mean, 1.1 * figures[Method::paper].normal_error.mean)
        << vcg_core::method_name(method);
    EXPECT_GT(measured.true_tangential_drift, 1.2 * figures[Method::paper].true_tangential_drift)
        << vcg_core::method_name(method);
  }
}

TEST_P(Ranking, TheOthersComeInTheKnownOrderAtSharpEdges) {
  auto figures = figures_at(GetParam());
  const auto error = [&](Method method) { return figures[method].sharp_normal_error.mean; };
  EXPECT_LT(1.3 * error(Method::jones), error(Method::taubin));
  EXPECT_LT(1.1 * error(Method::taubin), error(Method::laplacian));
  EXPECT_LT(1.1 * error(Method::bmd), error(Method::laplacian));
  EXPECT_LT(1.1 * error(Method::hc), error(Method::laplacian));
}

// vcglib's step adds the neighbours' mean displacement where the article subtracts it: nothing is pushed back.
TEST(VcglibsHc, ShrinksWhereTheArticlesDoesNot) {
  const mesh_tools::Mesh clean = mesh_tools::make_shape("cad_part", 6500);
  const mesh_tools::Measurement articles = figures_of(Method::hc, 0.2, clean);
  const mesh_tools::Measurement vcglibs = figures_of(Method::hc_vcglib, 0.2, clean);
  EXPECT_LT(*vcglibs.volume_change_percent, -8);
  EXPECT_NEAR(*articles.volume_change_percent, 0, 0.5);
  EXPECT_LT(articles.normal_error.mean, 0.6 * vcglibs.normal_error.mean);
  EXPECT_LT(articles.sharp_normal_error.mean, 0.85 * vcglibs.sharp_normal_error.mean);
}

INSTANTIATE_TEST_SUITE_P(Noise, Ranking, testing::Values(0.1, 0.2));

}  // namespace
