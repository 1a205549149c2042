// SPDX-License-Identifier: GPL-3.0-or-later
// Every parameter of every method at values that make no sense, and at the ends of what is allowed.

#include <algorithm>
#include <cfloat>
#include <climits>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/print_method.h>
#include <support/raw_snapshot.h>
#include <support/smoothed_by.h>
#include <vcg_core/distance_colors.h>
#include <vcg_core/geodesic_distance.h>

namespace {

using namespace test_support;
using vcg_core::Arithmetic;
using vcg_core::Method;
using vcg_core::MethodInfo;
using vcg_core::ParameterInfo;
using vcg_core::SmoothingParameters;

std::vector<ParameterInfo> real_parameters(const MethodInfo& method) {
  std::vector<ParameterInfo> rows;
  for (const ParameterInfo& row : method.parameters)
    if (row.kind() == ParameterInfo::Kind::real) rows.push_back(row);
  return rows;
}

double largest(const ParameterInfo& row) { return std::min(row.values.most, DBL_MAX); }

/// Values that the row forbids.
std::vector<double> bad_values(const ParameterInfo& row) {
  const double infinity = std::numeric_limits<double>::infinity();
  switch (row.kind()) {
    case ParameterInfo::Kind::real: {
      std::vector<double> bad{0.0, -0.0, -1.5, -DBL_TRUE_MIN, -DBL_MAX, std::nan(""), infinity, -infinity};
      if (row.values.most < DBL_MAX) bad.push_back(std::nextafter(row.values.most, infinity));
      return bad;
    }
    case ParameterInfo::Kind::integer:
      return {row.values.least - 1, -7, INT_MIN};
    case ParameterInfo::Kind::choice:
      return {-1, static_cast<double>(row.values.choices.size()), INT_MIN, INT_MAX};
    default:
      return {};
  }
}

class ParameterValues : public testing::TestWithParam<MethodInfo> {
 protected:
  void expect_refused(const SmoothingParameters& parameters, const std::string& name) {
    DoubleMesh mesh;
    fill(mesh, potato(1));
    const RawSnapshot<DoubleMesh> untouched(mesh);
    try {
      vcg_core::smooth(mesh, GetParam().method, parameters);
      ADD_FAILURE() << "no error";
    } catch (const vcg_core::InvalidParameter& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + " is ", 0), 0u) << error.what();
    }
    EXPECT_TRUE(untouched.unchanged());
  }

  /// Calls until the second report, which is the first after the beginning, is answered by a cancel.
  void expect_cancellable(const SmoothingParameters& parameters) {
    DoubleMesh mesh;
    fill(mesh, potato(1));
    const RawSnapshot<DoubleMesh> untouched(mesh);
    int calls = 0;
    const auto progress = [&](double, const char*) { return ++calls < 2; };
    EXPECT_THROW(vcg_core::smooth(mesh, GetParam().method, parameters, progress), vcg_core::Cancelled);
    EXPECT_TRUE(untouched.unchanged());
  }
};

TEST_P(ParameterValues, ThatAreNotAllowedAreRefusedByName) {
  std::vector<ParameterInfo> rows = GetParam().parameters;
  for (const ParameterInfo& row : vcg_core::run_parameters<SmoothingParameters>()) rows.push_back(row);
  for (const ParameterInfo& row : rows)
    for (const double value : bad_values(row)) {
      SCOPED_TRACE(row.name + " = " + std::to_string(value));
      SmoothingParameters parameters = GetParam().defaults;
      row.set(parameters, value);
      expect_refused(parameters, row.name);
    }
}

// Not even values that no method allows.
TEST_P(ParameterValues, ThatTheMethodDoesNotKnowHaveNoEffect) {
  const FlatMesh expected = smoothed_by(GetParam().method, potato(1), GetParam().defaults).mesh;
  for (const MethodInfo& other : vcg_core::methods())
    for (const ParameterInfo& row : other.parameters) {
      if (GetParam().uses(row.member)) continue;
      std::vector<double> values = bad_values(row);
      if (values.empty()) values.push_back(1);
      for (const double value : values) {
        SCOPED_TRACE(row.name + " = " + std::to_string(value));
        SmoothingParameters parameters = GetParam().defaults;
        row.set(parameters, value);
        EXPECT_TRUE(same_bits(smoothed_by(GetParam().method, potato(1), parameters).mesh, expected));
      }
    }
}

// All weights but one's own vanish, or none does: no NaN, and nothing that flies away.
TEST_P(ParameterValues, AtTheEndsOfWhatIsAllowedGiveFinitePositions) {
  const FlatMesh mesh = potato(1);
  const double e = average_edge_length(mesh);
  for (const ParameterInfo& row : real_parameters(GetParam()))
    for (const double value : {DBL_TRUE_MIN, DBL_MIN, 1e-200, 1e200, DBL_MAX})
      for (const Arithmetic arithmetic : {Arithmetic::fast, Arithmetic::reference}) {
        if (arithmetic == Arithmetic::reference && GetParam().method != Method::paper) continue;
        SCOPED_TRACE(row.name + " = " + std::to_string(value));
        SmoothingParameters parameters = GetParam().defaults;
        row.set(parameters, std::min(value, largest(row)));
        parameters.iterations = 2;
        parameters.arithmetic = arithmetic;
        const SmoothedBy result = smoothed_by(GetParam().method, mesh, parameters);
        EXPECT_TRUE(all_finite(result.mesh));
        EXPECT_LT(difference(result.mesh, mesh, 0).largest, 10 * e);
        EXPECT_TRUE(std::isfinite(result.report.volume_after));
        EXPECT_TRUE(std::isfinite(result.report.rms_displacement));
      }
}

TEST_P(ParameterValues, OfAllParametersAtOnceAtTheEnds) {
  const FlatMesh mesh = potato(1);
  const std::vector<ParameterInfo> rows = real_parameters(GetParam());
  for (int which = 0; which < 1 << rows.size(); ++which) {
    SmoothingParameters parameters = GetParam().defaults;
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k].set(parameters, (which >> k & 1) != 0 ? largest(rows[k]) : DBL_TRUE_MIN);
    EXPECT_TRUE(all_finite(smoothed_by(GetParam().method, mesh, parameters).mesh)) << which;
  }
}

TEST_P(ParameterValues, OfMoreThreadsThanAnySystemHas) {
  SmoothingParameters parameters = GetParam().defaults;
  parameters.threads = 1;
  const FlatMesh expected = smoothed_by(GetParam().method, potato(1), parameters).mesh;
  parameters.threads = INT_MAX;
  EXPECT_TRUE(same_bits(smoothed_by(GetParam().method, potato(1), parameters).mesh, expected));
}

TEST_P(ParameterValues, OfMorePassesThanAnyoneWaitsForCanBeCancelled) {
  if (GetParam().method == Method::jones) return;
  SmoothingParameters parameters = GetParam().defaults;
  parameters.iterations = INT_MAX;
  expect_cancellable(parameters);
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, ParameterValues, testing::ValuesIn(vcg_core::methods()),
                         [](const auto& instance) { return instance.param.name; });

TEST(GeodesicValues, OfStartVertexOutsideTheMeshAreRefused) {
  DoubleMesh mesh;
  fill(mesh, potato(1));
  for (const std::size_t source : {std::size_t(42), std::size_t(1) << 32, std::numeric_limits<std::size_t>::max()})
    EXPECT_THROW(vcg_core::geodesic_distances(mesh, source), vcg_core::InvalidParameter) << source;
}

TEST(GeodesicValues, OfNumbersOfLines) {
  DoubleMesh mesh;
  fill(mesh, potato(1));
  const std::vector<double> distance = vcg_core::geodesic_distances(mesh, 0);
  for (const int bad : {-1, INT_MIN})
    EXPECT_THROW(vcg_core::distance_colors(mesh, distance, bad), vcg_core::InvalidParameter);
  for (const int allowed : {0, 1, INT_MAX})
    EXPECT_EQ(vcg_core::distance_colors(mesh, distance, allowed).size(), distance.size());
}

}  // namespace
