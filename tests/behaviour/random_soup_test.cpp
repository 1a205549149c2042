// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever triangles come: no NaN, no crash, nothing touched that is not to move. Random meshes, shrunk when they fail.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <support/comparison.h>
#include <support/draw.h>
#include <support/mesh_census.h>
#include <support/mesh_types.h>
#include <support/naive_geodesics.h>
#include <support/naive_reference.h>
#include <support/smoothed.h>
#include <support/smoothed_by.h>
#include <support/smoothing_path.h>
#include <vcg_core/geodesic_distance.h>

namespace {

using namespace test_support;

/// A tube with three sides and `rings` rings an edge apart, closed at both ends: distances reach from both sides.
FlatMesh tube(std::size_t rings) {
  FlatMesh mesh;
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (std::size_t side = 0; side < 3; ++side) {
      const auto z = static_cast<double>(ring) + 0.2 * std::sin(static_cast<double>(7 * ring + 3 * side));
      mesh.points.emplace_back(std::cos(2.1 * static_cast<double>(side)), std::sin(2.1 * static_cast<double>(side)), z);
      if (ring == 0) continue;
      const std::size_t a = 3 * ring + side;
      const std::size_t b = 3 * ring + (side + 1) % 3;
      mesh.faces.push_back({a, a - 3, b - 3});
      mesh.faces.push_back({a, b - 3, b});
    }
  mesh.faces.push_back({2, 1, 0});
  mesh.faces.push_back({3 * rings - 3, 3 * rings - 2, 3 * rings - 1});
  return mesh;
}

/// Few vertices on a small lattice, many faces between them at random: every defect at once. Now and then they lie at
/// the end of a tube that is longer than 128 |e|.
FlatMesh random_soup() {
  const std::size_t vertices = draw<std::size_t>(3, 12);
  FlatMesh soup;
  for (std::size_t v = 0; v < vertices; ++v) {
    const int x = draw(-3, 4);
    const int y = draw(-3, 4);
    soup.points.emplace_back(x, y, draw(-3, 4));
  }
  const std::size_t faces = draw<std::size_t>(1, 25);
  for (std::size_t f = 0; f < faces; ++f) {
    Triangle face;
    for (std::size_t& v : face) v = draw<std::size_t>(0, vertices);
    soup.faces.push_back(face);
  }
  if (draw(0, 8) == 0) {
    append(soup, tube(draw<std::size_t>(250, 350)));
    soup.faces.push_back({0, 1, vertices});
  }
  return soup;
}

vcg_core::SmoothingParameters random_parameters(vcg_core::SmoothingParameters parameters) {
  const auto positive = [] { return std::pow(10.0, draw(-20, 21) / 10.0); };
  parameters.sigma_c = positive();
  parameters.sigma_s = positive();
  parameters.sigma_n = positive();
  parameters.rho = positive();
  parameters.boundary = *rc::gen::element(vcg_core::Boundary::fixed, vcg_core::Boundary::free);
  parameters.gaussian = *rc::gen::element(vcg_core::GaussianForm::standard_deviation, vcg_core::GaussianForm::printed);
  return parameters;
}

/// For the message of a failure.
std::string description(const FlatMesh& soup) {
  std::ostringstream text;
  for (const Point& p : soup.points) text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  for (const Triangle& f : soup.faces) text << "f " << f[0] << " " << f[1] << " " << f[2] << " (from 0)\n";
  return text.str();
}

bool has_edge(const FlatMesh& soup) { return average_edge_length(soup) > 0; }

RC_GTEST_PROP(RandomSoup, GivesFinitePositionsAndAnHonestReport, ()) {
  const FlatMesh soup = random_soup();
  RC_LOG() << description(soup);
  for (const SmoothingPath& path : smoothing_paths()) {
    DoubleMesh mesh;
    fill(mesh, soup);
    vcg_core::SmoothingParameters parameters = random_parameters(path.parameters);
    parameters.iterations = draw(1, 4);
    if (!has_edge(soup)) {
      RC_ASSERT_THROWS_AS(vcg_core::smooth(mesh, vcg_core::Method::paper, parameters), vcg_core::InvalidMesh);
      continue;
    }
    const vcg_core::SmoothingReport report = vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
    const FlatMesh result = flat(mesh);
    RC_ASSERT(all_finite(result));
    std::size_t moved = 0;
    const NaiveReference reference(soup);
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
      const bool has_moved = result.points[v] != soup.points[v];
      moved += has_moved;
      if (parameters.boundary == vcg_core::Boundary::fixed && reference.on_border(v)) RC_ASSERT(!has_moved);
    }
    RC_ASSERT(report.moved_vertices == moved);
    RC_ASSERT(report.vertices == soup.points.size());
    RC_ASSERT(std::isfinite(report.volume_after) && std::isfinite(report.rms_displacement));
    RC_ASSERT(report.rms_displacement <= report.max_displacement * (1 + 1e-12));
  }
}

RC_GTEST_PROP(RandomSoup, GivesFinitePositionsAndRightCountsByEveryMethod, ()) {
  const FlatMesh soup = random_soup();
  RC_LOG() << description(soup);
  if (!has_edge(soup)) return;
  const MeshCensus census = take_census(soup);
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    RC_LOG() << method.name << "\n";
    vcg_core::SmoothingParameters parameters = random_parameters(method.defaults);
    parameters.iterations = draw(1, 4);
    const auto [result, report] = smoothed_by(method.method, soup, parameters);
    RC_ASSERT(all_finite(result));
    const bool fixed = parameters.boundary == vcg_core::Boundary::fixed;
    RC_ASSERT(report.fixed_vertices == (fixed ? census.border : 0));
    RC_ASSERT(report.border_vertices == census.border);
    RC_ASSERT(report.non_manifold_vertices == census.non_manifold);
    RC_ASSERT(report.coincident_vertices == census.coincident);
    RC_ASSERT(report.degenerate_faces == census.degenerate_faces);
    RC_ASSERT(report.skipped_vertices.isolated == census.isolated);
    RC_ASSERT(std::isfinite(report.max_displacement) && std::isfinite(report.volume_after));
  }
}

RC_GTEST_PROP(RandomSoup, GivesTheDistancesOfTheReference, ()) {
  const FlatMesh soup = random_soup();
  if (!has_edge(soup)) return;
  DoubleMesh mesh;
  fill(mesh, soup);
  const auto source = draw<std::size_t>(0, soup.points.size());
  const std::vector<double> distance = vcg_core::geodesic_distances(mesh, source);
  const std::vector<double> expected = naive_geodesics(soup, source, 1e-14);
  RC_LOG() << description(soup) << "source " << source << "\n";
  for (std::size_t v = 0; v < distance.size(); ++v)
    RC_ASSERT(distance[v] == expected[v] || std::abs(distance[v] - expected[v]) < 1e-6);
}

}  // namespace
