// What the paper claims of its figure 9, on the CAD part: of Table 1's six methods its filter keeps sharp edges best.

#include <map>

#include <gtest/gtest.h>

#include <mesh_tools/measure.h>
#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>
#include <vcg_core/smoothing.h>

namespace {

using vcg_core::Method;

/// Figures of the six methods on the CAD part with noise along the normals.
std::map<Method, mesh_tools::Measurement> figures_at(double noise) {
  const mesh_tools::Mesh clean = mesh_tools::make_shape("cad_part", 6500);
  std::map<Method, mesh_tools::Measurement> figures;
  for (const Method method :
       {Method::laplacian, Method::hc, Method::taubin, Method::jones, Method::bmd, Method::paper}) {
    mesh_tools::Mesh mesh = mesh_tools::make_shape("cad_part", 6500);
    mesh_tools::add_noise(mesh, noise, 1, mesh_tools::NoiseDirection::normal);
    vcg_core::smooth(mesh, method, vcg_core::method_info(method).defaults);
    figures.emplace(method, mesh_tools::measure(mesh, clean));
  }
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
  // vcglib's HC shrinks like its Laplacian: see hc_filter.h.
  EXPECT_NEAR(error(Method::hc) / error(Method::laplacian), 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Noise, Ranking, testing::Values(0.1, 0.2));

}  // namespace
