// What the paper claims of its figure 9, on the CAD part: of Table 1's six methods its filter keeps sharp edges best.

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include <vcg/complex/complex.h>

#include <vcg/complex/algorithms/smooth.h>  // needs complex.h before it

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

// vcglib's HC step adds the mean of the neighbours' ways where the article (Vollmer, Mencl, Mueller 1999) subtracts it.
// With way(v) from v to the mean of its neighbours, which a Taubin step of lambda 1 and mu 0 walks, vcglib's step and
// the article's add up to it: so the article's is at hand without being written again.
TEST(VcglibsHc, ShrinksWhereTheArticlesDoesNot) {
  using Smooth = vcg::tri::Smooth<mesh_tools::Mesh>;
  const mesh_tools::Mesh clean = mesh_tools::make_shape("cad_part", 6500);
  mesh_tools::Mesh mesh = mesh_tools::make_shape("cad_part", 6500);
  mesh_tools::add_noise(mesh, 0.2, 1, mesh_tools::NoiseDirection::normal);
  mesh_tools::Mesh by_article;
  vcg::tri::Append<mesh_tools::Mesh, mesh_tools::Mesh>::MeshCopy(by_article, mesh);
  vcg_core::smooth(mesh, Method::hc, vcg_core::method_info(Method::hc).defaults);

  const auto positions = [&] {
    std::vector<vcg::Point3d> p;
    for (const auto& vertex : by_article.vert) p.push_back(vertex.cP());
    return p;
  };
  const auto place = [&](const std::vector<vcg::Point3d>& p) {
    for (std::size_t v = 0; v < p.size(); ++v) by_article.vert[v].P() = p[v];
  };
  for (int step = 0; step < 20; ++step) {
    std::vector<vcg::Point3d> before = positions();
    Smooth::VertexCoordLaplacianHC(by_article, 1);
    const std::vector<vcg::Point3d> by_vcglib = positions();
    place(before);
    Smooth::VertexCoordTaubin(by_article, 1, 1, 0);
    const std::vector<vcg::Point3d> mean_of_neighbors = positions();
    for (std::size_t v = 0; v < before.size(); ++v) before[v] += mean_of_neighbors[v] - by_vcglib[v];
    place(before);
  }
  const mesh_tools::Measurement vcglibs = mesh_tools::measure(mesh, clean);
  const mesh_tools::Measurement articles = mesh_tools::measure(by_article, clean);
  EXPECT_LT(*vcglibs.volume_change_percent, -8);
  EXPECT_NEAR(*articles.volume_change_percent, 0, 0.5);
  EXPECT_LT(articles.normal_error.mean, 0.6 * vcglibs.normal_error.mean);
  EXPECT_LT(articles.sharp_normal_error.mean, 0.85 * vcglibs.sharp_normal_error.mean);
}

INSTANTIATE_TEST_SUITE_P(Noise, Ranking, testing::Values(0.1, 0.2));

}  // namespace
