// SPDX-License-Identifier: GPL-3.0-or-later
// The table of methods, and what every method promises.

#include <cmath>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/noisy_shapes.h>
#include <support/print_method.h>
#include <support/progress_log.h>
#include <support/smoothed_by.h>

namespace {

using namespace test_support;
using vcg_core::Method;
using vcg_core::MethodInfo;
using vcg_core::SmoothingParameters;

TEST(MethodTable, FindsEveryMethodByItsName) {
  ASSERT_GE(vcg_core::methods().size(), 6u);
  for (const MethodInfo& info : vcg_core::methods()) {
    EXPECT_EQ(vcg_core::method_from_name(info.name), info.method);
    EXPECT_EQ(vcg_core::method_name(info.method), info.name);
    EXPECT_FALSE(info.title.empty());
  }
  EXPECT_FALSE(vcg_core::method_from_name("Paper").has_value());
  EXPECT_FALSE(vcg_core::method_from_name("").has_value());
}

TEST(MethodTable, HoldsTable1) {
  const auto defaults = [](const char* name) {
    return vcg_core::method_info(*vcg_core::method_from_name(name)).defaults;
  };
  for (const char* name : {"laplacian", "hc", "hc_vcglib", "taubin"}) EXPECT_EQ(defaults(name).iterations, 20) << name;
  for (const char* name : {"jones", "bmd", "paper"}) {
    EXPECT_EQ(defaults(name).iterations, 1) << name;
    EXPECT_EQ(defaults(name).sigma_c, 2) << name;
    EXPECT_EQ(defaults(name).sigma_s, 1) << name;
  }
  EXPECT_EQ(defaults("paper").sigma_n, 0.3);
  EXPECT_TRUE(vcg_core::method_info(Method::paper).uses(&SmoothingParameters::sigma_n));
  EXPECT_FALSE(vcg_core::method_info(Method::bmd).uses(&SmoothingParameters::sigma_n));
  EXPECT_FALSE(vcg_core::method_info(Method::taubin).uses(&SmoothingParameters::sigma_c));
}

class EveryMethod : public testing::TestWithParam<MethodInfo> {
 protected:
  Method method() const { return GetParam().method; }
  SmoothingParameters defaults() const { return GetParam().defaults; }
};

TEST_P(EveryMethod, TakesAwayNoise) {
  const FlatMesh clean = noisy_shape("plane_random_diagonals", 2000, 0);
  const FlatMesh noisy = noisy_shape("plane_random_diagonals", 2000, 0.2);
  const FlatMesh result = smoothed_by(method(), noisy, defaults()).mesh;
  const auto roughness = [](const FlatMesh& mesh) {
    double sum = 0;
    for (const Point& p : mesh.points) sum += p[2] * p[2];
    return std::sqrt(sum);
  };
  ASSERT_EQ(roughness(clean), 0);
  EXPECT_LT(roughness(result), 0.7 * roughness(noisy));
}

TEST_P(EveryMethod, GivesTheSameWhateverTheNumberOfThreads) {
  const FlatMesh mesh = noisy_shape("cad_part", 3000);
  SmoothingParameters p = defaults();
  p.threads = 1;
  const FlatMesh one = smoothed_by(method(), mesh, p).mesh;
  for (const int threads : {2, 5}) {
    p.threads = threads;
    EXPECT_TRUE(same_bits(smoothed_by(method(), mesh, p).mesh, one)) << threads << " threads";
  }
}

TEST_P(EveryMethod, HoldsBordersAndWhatIsNotSelected) {
  const auto noise = [](double x, double y) { return 0.02 * std::sin(7919.1 * x + 10473.3 * y * y + 511.7 * x * y); };
  const FlatMesh mesh =
      height_field(15, [&](double x, double y) { return 0.02 * std::sin(9 * x + 7 * y * y) + noise(x, y); });
  SmoothingParameters p = defaults();
  p.boundary = vcg_core::Boundary::fixed;
  const FlatMesh fixed = smoothed_by(method(), mesh, p).mesh;
  p.selected_only = true;
  p.boundary = vcg_core::Boundary::free;
  DoubleMesh with_selection;
  fill(with_selection, mesh);
  for (std::size_t v = 0; v < mesh.points.size(); v += 3) with_selection.vert[v].SetS();
  const auto report = vcg_core::smooth(with_selection, method(), p);
  const FlatMesh selected = flat(with_selection);
  EXPECT_EQ(report.fixed_vertices, 150u);
  EXPECT_GT(report.moved_vertices, 50u);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const std::size_t x = v % 15, y = v / 15;
    if (x == 0 || y == 0 || x == 14 || y == 14) {
      EXPECT_EQ(fixed.points[v], mesh.points[v]) << v;
    }
    if (v % 3 != 0) {
      EXPECT_EQ(selected.points[v], mesh.points[v]) << v;
    }
  }
}

TEST_P(EveryMethod, FollowsScaleAndPlace) {
  const FlatMesh mesh = potato(3);
  const FlatMesh result = smoothed_by(method(), mesh, defaults()).mesh;
  const double e = average_edge_length(mesh);
  const bool packs = method() == Method::guided;  // its normals, and displacements in single precision
  for (const double scale : {1e-12, 1e12}) {
    const auto scaled = [scale](const Point& p) { return p * scale; };
    const FlatMesh other = smoothed_by(method(), transformed(mesh, scaled), defaults()).mesh;
    EXPECT_LE(difference(other, transformed(result, scaled), 0).largest, (packs ? 2e-4 : 1e-9) * e * scale) << scale;
  }
  const auto shifted = [](const Point& p) { return p + Point(1000, -2000, 500); };
  const FlatMesh other = smoothed_by(method(), transformed(mesh, shifted), defaults()).mesh;
  EXPECT_LE(difference(other, transformed(result, shifted), 0).largest, (packs ? 2e-4 : 1e-7) * e);
}

TEST_P(EveryMethod, StaysFiniteOnAllThatIsOdd) {
  FlatMesh mesh = noisy_shape("graded_cube", 600, 0.5);
  mesh.points.emplace_back(0.3, 0.3, 0.3);   // isolated
  mesh.faces.push_back({1, 1, 2});           // a repeated vertex
  mesh.faces.push_back(mesh.faces.front());  // the same face twice
  const std::size_t n = mesh.points.size();
  for (int k = 0; k < 3; ++k) mesh.points.emplace_back(0.2 * k, 0, 2);  // a face without area
  mesh.faces.push_back({n, n + 1, n + 2});
  for (int k = 0; k < 3; ++k) mesh.points.push_back(Point(7, 7, 7));  // a face in one point
  mesh.faces.push_back({n + 3, n + 4, n + 5});
  for (const double sigma : {1e-200, 1e-3, 1.0, 1e3, 1e200}) {
    SmoothingParameters p = defaults();
    p.sigma_c = p.sigma_s = sigma;
    p.boundary = vcg_core::Boundary::free;
    const SmoothedBy result = smoothed_by(method(), mesh, p);
    EXPECT_TRUE(all_finite(result.mesh)) << sigma;
    EXPECT_TRUE(std::isfinite(result.report.volume_after)) << sigma;
  }
}

TEST_P(EveryMethod, LeavesTheMeshWhenItIsCancelled) {
  DoubleMesh mesh;
  fill(mesh, noisy_shape("cad_part", 20000));
  const FlatMesh before = flat(mesh);
  for (const double at : {0.0, 0.3, 1.0}) {
    ProgressLog log([at](const ProgressLog::Call& call) { return call.fraction < at; });
    EXPECT_THROW(vcg_core::smooth(mesh, method(), defaults(), log.callable()), vcg_core::Cancelled) << at;
    EXPECT_TRUE(same_bits(flat(mesh), before)) << at;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(vcg_core::methods()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
