// SPDX-License-Identifier: GPL-3.0-or-later
// Every family of bad meshes through every method and function: the documented error and a mesh that is as it was bit
// for bit, or a finite result and a report whose counts are right.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <support/bad_meshes.h>
#include <support/comparison.h>
#include <support/mesh_census.h>
#include <support/mesh_types.h>
#include <support/print_method.h>
#include <support/raw_snapshot.h>
#include <support/result_census.h>
#include <vcg_core/distance_colors.h>
#include <vcg_core/geodesic_distance.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::Boundary;
using vcg_core::Method;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;

/// What has to be refused is refused, in words that name it.
template <class Call>
void expect_refused(const BadMesh& bad, const Call& call) {
  try {
    call();
    ADD_FAILURE() << "no error";
  } catch (const vcg_core::InvalidMesh& error) {
    EXPECT_NE(std::string(error.what()).find(bad.error), std::string::npos) << error.what();
  }
}

void expect_counts_of_mesh(const SmoothingReport& report, const FlatMesh& mesh, Boundary boundary) {
  const MeshCensus census = take_census(mesh);
  EXPECT_EQ(report.vertices, mesh.points.size());
  EXPECT_EQ(report.border_vertices, census.border);
  EXPECT_EQ(report.non_manifold_vertices, census.non_manifold);
  EXPECT_EQ(report.coincident_vertices, census.coincident);
  EXPECT_EQ(report.degenerate_faces, census.degenerate_faces);
  EXPECT_EQ(report.fixed_vertices, boundary == Boundary::fixed ? census.border : 0u);
  EXPECT_EQ(report.skipped_vertices.isolated, census.isolated);
}

void expect_warnings(const SmoothingReport& report) {
  const auto has = [warnings = report.warnings()](const char* part) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
  };
  EXPECT_EQ(has("--weld-distance"),
            report.nearly_coincident_vertices > 0 && 10 * report.nearly_coincident_vertices >= report.border_vertices);
  EXPECT_EQ(has("belong to no face"), report.skipped_vertices.isolated > 0);
  EXPECT_EQ(has("have no defined normal"), report.skipped_vertices.undefined_normal > 0);
}

/// Compares with the positions as they were stored before and after; `rounding` is that of one stored coordinate.
void expect_displacements(const SmoothingReport& report, const FlatMesh& before, const FlatMesh& after,
                          double rounding) {
  std::size_t moved = 0;
  long double largest = 0;
  long double sum = 0;
  for (std::size_t v = 0; v < before.points.size(); ++v) {
    if (before.points[v] == after.points[v]) continue;
    ++moved;
    using LongPoint = vcg::Point3<long double>;
    const LongPoint step = LongPoint::Construct(after.points[v]) - LongPoint::Construct(before.points[v]);
    const long double d = std::sqrt(step.SquaredNorm());
    largest = std::max(largest, d);
    sum += d * d;
  }
  EXPECT_EQ(report.moved_vertices, moved);
  if (moved == 0) {
    EXPECT_EQ(report.max_displacement, 0);
    return;
  }
  EXPECT_NEAR(report.max_displacement, static_cast<double>(largest), static_cast<double>(largest) * 1e-9 + rounding);
  const auto rms = static_cast<double>(std::sqrt(sum / static_cast<long double>(moved)));
  EXPECT_NEAR(report.rms_displacement, rms, rms * 1e-9 + rounding);
}

double largest_coordinate(const FlatMesh& mesh) {
  double largest = 0;
  for (const Point& p : mesh.points) largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return largest;
}

template <class Mesh>
void smooth_and_check(const BadMesh& bad, Method method, const SmoothingParameters& parameters) {
  Mesh mesh;
  fill(mesh, bad);
  if (!bad.error.empty()) {
    const RawSnapshot<Mesh> untouched(mesh);
    expect_refused(bad, [&] { vcg_core::smooth(mesh, method, parameters); });
    EXPECT_TRUE(untouched.unchanged());
    return;
  }
  const FlatMesh before = flat(mesh);
  const SmoothingReport report = vcg_core::smooth(mesh, method, parameters);
  const FlatMesh after = flat(mesh);
  EXPECT_EQ(after.faces, before.faces);
  EXPECT_TRUE(all_finite(after));
  expect_counts_of_mesh(report, before, parameters.boundary);
  expect_warnings(report);
  if (parameters.iterations == 1) {  // a vertex that is skipped in the first pass may move in a later one
    EXPECT_LE(report.moved_vertices + report.fixed_vertices + report.skipped_vertices.total(), report.vertices);
  }
  if (!bad.has_figures) return;
  using Scalar = typename Mesh::ScalarType;
  const double rounding = 4 * largest_coordinate(before) * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  expect_displacements(report, before, after, rounding);
  const ResultCensus result = take_census(before, after);
  EXPECT_EQ(report.flipped_faces, result.flipped_faces);
  EXPECT_EQ(report.far_moved_vertices, result.far_moved_vertices);
  EXPECT_EQ(report.beyond_ring_vertices, result.beyond_ring_vertices);
  EXPECT_TRUE(std::isfinite(report.volume_before) && std::isfinite(report.volume_after));
}

/// GoogleTest allows letters, digits and underscores.
std::string as_test_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

using FamilyAndMethod = std::tuple<std::string, vcg_core::MethodInfo>;
class EveryMethod : public testing::TestWithParam<FamilyAndMethod> {
 protected:
  /// Both precisions, borders held and free, one pass and the method's own number.
  template <class Mesh>
  void run() {
    const BadMesh bad = bad_mesh<typename Mesh::ScalarType>(std::get<0>(GetParam()));
    const vcg_core::MethodInfo& method = std::get<1>(GetParam());
    for (const Boundary boundary : {Boundary::fixed, Boundary::free})
      for (const int iterations : {1, std::max(2, method.defaults.iterations)}) {
        if (bad.large_support && (iterations > 1 || boundary == Boundary::free) &&
            method.uses(&SmoothingParameters::rho))
          continue;
        SCOPED_TRACE(std::string(boundary == Boundary::fixed ? "fixed" : "free") + " border, " +
                     std::to_string(iterations) + " passes");
        SmoothingParameters parameters = method.defaults;
        parameters.boundary = boundary;
        parameters.iterations = iterations;
        smooth_and_check<Mesh>(bad, method.method, parameters);
      }
  }
};

TEST_P(EveryMethod, RefusesOrGivesAFiniteResultInDoublePrecision) { run<DoubleMesh>(); }

TEST_P(EveryMethod, RefusesOrGivesAFiniteResultInSinglePrecision) { run<FloatMesh>(); }

INSTANTIATE_TEST_SUITE_P(BadMeshes, EveryMethod,
                         testing::Combine(testing::ValuesIn(bad_mesh_names()), testing::ValuesIn(vcg_core::methods())),
                         [](const auto& instance) {
                           return as_test_name(std::get<0>(instance.param) + "_" + std::get<1>(instance.param).name);
                         });

class EveryFamily : public testing::TestWithParam<std::string> {
 protected:
  template <class Mesh>
  void measure_distances() {
    const BadMesh bad = bad_mesh<typename Mesh::ScalarType>(GetParam());
    Mesh mesh;
    fill(mesh, bad);
    const RawSnapshot<Mesh> untouched(mesh);
    if (!bad.error.empty()) {
      expect_refused(bad, [&] { vcg_core::geodesic_distances(mesh, 0); });
    } else {
      for (const std::size_t source : {std::size_t(0), mesh.vert.size() / 2}) {
        const std::vector<double> distance = vcg_core::geodesic_distances(mesh, source);
        ASSERT_EQ(distance.size(), mesh.vert.size());
        EXPECT_EQ(distance[source], 0);
        for (std::size_t v = 0; v < distance.size(); ++v) {
          EXPECT_GE(distance[v], 0);  // no NaN
          if (mesh.vert[v].IsD()) {
            EXPECT_TRUE(std::isinf(distance[v]));
          }
        }
        EXPECT_EQ(vcg_core::distance_colors(mesh, distance, 7).size(), mesh.vert.size());
      }
      for (const std::size_t deleted : bad.deleted_vertices)
        EXPECT_THROW(vcg_core::geodesic_distances(mesh, deleted), vcg_core::InvalidParameter);
    }
    EXPECT_TRUE(untouched.unchanged());
  }
};

TEST_P(EveryFamily, IsRefusedOrHasDistancesAndColours) {
  measure_distances<DoubleMesh>();
  measure_distances<FloatMesh>();
}

// The guided method smooths colour and quality on request; among them are values that are no numbers.
TEST_P(EveryFamily, IsRefusedOrHasSmoothColoursAndQualities) {
  const BadMesh bad = bad_mesh<double>(GetParam());
  RichMesh mesh;
  fill(mesh, bad);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    mesh.vert[v].Q() = v % 10 == 3 ? std::nan("") : std::sin(static_cast<double>(v));
    mesh.vert[v].C() = vcg::Color4b(static_cast<unsigned char>(v), static_cast<unsigned char>(7 * v), 0, 255);
  }
  SmoothingParameters parameters = vcg_core::method_info(Method::guided).defaults;
  parameters.smooth_color = true;
  const RawSnapshot<RichMesh> untouched(mesh);
  if (!bad.error.empty()) {
    expect_refused(bad, [&] { vcg_core::smooth(mesh, Method::guided, parameters); });
    EXPECT_TRUE(untouched.unchanged());
    return;
  }
  vcg_core::smooth(mesh, Method::guided, parameters);
  EXPECT_TRUE(all_finite(flat(mesh)));
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) EXPECT_EQ(std::isnan(mesh.vert[v].Q()), v % 10 == 3);
}

INSTANTIATE_TEST_SUITE_P(BadMeshes, EveryFamily, testing::ValuesIn(bad_mesh_names()),
                         [](const auto& instance) { return as_test_name(instance.param); });

// Names of tests and of files come from them.
TEST(BadMeshes, AreEachThereOnceInBothPrecisions) {
  std::vector<std::string> names = bad_mesh_names();
  std::vector<std::string> in_floats;
  for (const BadMesh& bad : bad_meshes<float>()) in_floats.push_back(bad.name);
  EXPECT_EQ(in_floats, names);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
