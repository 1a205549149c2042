// SPDX-License-Identifier: GPL-3.0-or-later
// The library against the naive reference, vertex by vertex: on all shapes of the tools and on real models.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <mesh_tools/random.h>
#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/library_neighborhoods.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>
#include <support/test_data.h>

namespace {

using namespace test_support;
using vcg_core::SmoothingParameters;

/// What came out of comparing some vertices.
struct Agreement {
  std::size_t compared = 0;
  std::size_t ambiguous = 0;      ///< left out: a distance too near to the cut-off
  std::size_t other_members = 0;  ///< left out: the library's neighbourhood is another one
  std::size_t moved = 0;          ///< by more than 0.001 |e|
  double largest = 0;             ///< of the differences of position, in |e|
};

std::ostream& operator<<(std::ostream& out, const Agreement& a) {
  return out << a.compared << " compared, " << a.moved << " moved, " << a.ambiguous << " ambiguous, " << a.other_members
             << " with another neighbourhood, largest difference " << a.largest << " |e|";
}

Agreement compare(const FlatMesh& mesh, const std::vector<std::size_t>& vertices, const SmoothingParameters& parameters,
                  double clearance, double reach = std::numeric_limits<double>::infinity()) {
  const NaiveReference reference(mesh, reach);
  const double e = reference.average_edge_length();
  LibraryNeighborhoods neighborhoods(mesh);
  const FlatMesh result = smoothed(mesh, parameters);
  Agreement agreement;
  for (const std::size_t v : vertices) {
    const NaiveVertex expected = reference.smooth(v, parameters);
    if (expected.clearance < clearance) {
      ++agreement.ambiguous;
    } else if (neighborhoods.of(v, parameters.rho * parameters.sigma_c) != expected.neighborhood) {
      ++agreement.other_members;
    } else {
      ++agreement.compared;
      agreement.moved += (expected.position - mesh.points[v]).Norm() > 1e-3 * e;
      agreement.largest = std::max(agreement.largest, (result.points[v] - expected.position).Norm() / e);
    }
  }
  return agreement;
}

/// Nearly all vertices are compared. Neighbourhoods differ where the library's cut-off keeps a long edge, one end of
/// which lies far beyond it, from feeding a vertex inside.
void expect_agreement(const Agreement& agreement, double tolerance) {
  SCOPED_TRACE(testing::PrintToString(agreement));
  testing::Test::RecordProperty("agreement", testing::PrintToString(agreement));
  EXPECT_LE(agreement.largest, tolerance);
  EXPECT_GT(agreement.moved, agreement.compared / 2);
  EXPECT_LE(agreement.ambiguous, agreement.compared / 50);
  EXPECT_LE(agreement.other_members, agreement.compared / 100);
}

/// `wanted` vertices drawn by lot; all, if there are not many more.
std::vector<std::size_t> sample(std::size_t vertices, std::size_t wanted) {
  std::vector<std::size_t> result;
  mesh_tools::Random random(7);
  const bool all = vertices < 4 * wanted;
  for (std::size_t k = 0; k < (all ? vertices : wanted); ++k)
    result.push_back(all ? k : static_cast<std::size_t>(random.uniform() * static_cast<double>(vertices)));
  return result;
}

using Case = std::tuple<std::string, SmoothingPath>;

std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param).name;
  name.erase(std::remove(name.begin(), name.end(), '.'), name.end());
  return name;
}

class NaiveAgreementOnShapes : public testing::TestWithParam<Case> {};

TEST_P(NaiveAgreementOnShapes, WithTable1) {
  const auto& [shape, path] = GetParam();
  const FlatMesh mesh = noisy_shape(shape, 300);
  expect_agreement(compare(mesh, sample(mesh.points.size(), 80), path.parameters, path.clearance),
                   path.position_tolerance);
}

TEST_P(NaiveAgreementOnShapes, WithPrintedGaussiansSmallNeighborhoodsAndFreeBorders) {
  const auto& [shape, path] = GetParam();
  SmoothingParameters parameters = path.parameters;
  parameters.sigma_c = 1.7;
  parameters.sigma_s = 0.6;
  parameters.sigma_n = 0.2;
  parameters.rho = 1.3;
  parameters.boundary = vcg_core::Boundary::free;
  parameters.gaussian = vcg_core::GaussianForm::printed;
  const FlatMesh mesh = noisy_shape(shape, 150);
  expect_agreement(compare(mesh, sample(mesh.points.size(), 40), parameters, path.clearance), path.position_tolerance);
}

INSTANTIATE_TEST_SUITE_P(Shapes, NaiveAgreementOnShapes,
                         testing::Combine(testing::ValuesIn(shape_names()), testing::ValuesIn(smoothing_paths())),
                         name_of);

class NaiveAgreementOnModels : public testing::TestWithParam<Case> {};

TEST_P(NaiveAgreementOnModels, AtRandomVertices) {
  const auto& [name, path] = GetParam();
  const auto model = load_model(name);
  if (!model) GTEST_SKIP() << "no model " << name << " in ANISO_TEST_DATA";
  const double reach = 20;  // in |e|: the cut-off of 4 and four times the longest edge of all models, 3.9
  expect_agreement(
      compare(model->noisy, sample(model->noisy.points.size(), 20), path.parameters, path.clearance, reach),
      path.position_tolerance);
}

INSTANTIATE_TEST_SUITE_P(Models, NaiveAgreementOnModels,
                         testing::Combine(testing::ValuesIn(model_names()), testing::ValuesIn(smoothing_paths())),
                         name_of);

class NaiveAgreement : public testing::TestWithParam<SmoothingPath> {};

/// Each pass begins with the normals of what the last one left, and keeps |e|, the unit, of the mesh as it was given.
TEST_P(NaiveAgreement, AfterSeveralPasses) {
  const FlatMesh mesh = potato(2);
  SmoothingParameters parameters = GetParam().parameters;
  for (const int passes : {2, 3}) {
    parameters.iterations = passes;
    EXPECT_TRUE(same_smoothing(smoothed(mesh, parameters), naive_smooth(mesh, parameters, passes), GetParam(),
                               average_edge_length(mesh)));
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, NaiveAgreement, testing::ValuesIn(smoothing_paths()), name_of_path);

}  // namespace
