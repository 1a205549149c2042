// SPDX-License-Identifier: GPL-3.0-or-later
// Which parameters are refused, with which words, and which odd ones are not.

#include <cfloat>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/naive_reference.h>
#include <support/raw_snapshot.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>

namespace {

using namespace test_support;
using vcg_core::InvalidParameter;
using vcg_core::SmoothingParameters;

struct Named {
  const char* name;
  double SmoothingParameters::*value;
};

class PositiveParameter : public testing::TestWithParam<Named> {};

TEST_P(PositiveParameter, IsRefusedWhenItIsNotAFiniteNumberAboveZero) {
  const double infinity = std::numeric_limits<double>::infinity();
  DoubleMesh mesh;
  fill(mesh, octahedron());
  const RawSnapshot<DoubleMesh> before(mesh);
  const struct {
    double value;
    const char* text;
  } cases[] = {{0.0, "0"}, {-0.0, "0"}, {-1.5, "-1.5"}, {std::nan(""), "nan"}, {infinity, "inf"}, {-infinity, "-inf"}};
  for (const auto& bad : cases) {
    SmoothingParameters parameters;
    parameters.*GetParam().value = bad.value;
    try {
      vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
      ADD_FAILURE() << "no error for " << GetParam().name << " = " << bad.text;
    } catch (const InvalidParameter& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(GetParam().name), std::string::npos) << message;
      EXPECT_NE(message.find(bad.text), std::string::npos) << message;
      EXPECT_NE(message.find("greater than 0"), std::string::npos) << message;
    }
    EXPECT_TRUE(before.unchanged());
  }
}

INSTANTIATE_TEST_SUITE_P(EachOfFour, PositiveParameter,
                         testing::Values(Named{"sigma_c", &SmoothingParameters::sigma_c},
                                         Named{"sigma_s", &SmoothingParameters::sigma_s},
                                         Named{"sigma_n", &SmoothingParameters::sigma_n},
                                         Named{"rho", &SmoothingParameters::rho}),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(SmoothingParameters, HaveTheDefaultsOfTheContract) {
  const SmoothingParameters defaults;
  EXPECT_EQ(defaults.sigma_c, 2);
  EXPECT_EQ(defaults.sigma_s, 1);
  EXPECT_EQ(defaults.sigma_n, 0.3);
  EXPECT_EQ(defaults.rho, 2);
  EXPECT_EQ(defaults.iterations, 1);
  EXPECT_EQ(defaults.boundary, vcg_core::Boundary::fixed);
  EXPECT_FALSE(defaults.selected_only);
  EXPECT_EQ(defaults.gaussian, vcg_core::GaussianForm::standard_deviation);
  EXPECT_EQ(defaults.threads, 0);
  EXPECT_NO_THROW(defaults.validate(vcg_core::Method::paper));
}

TEST(SmoothingParameters, IterationsBelowOneAreRefused) {
  for (const int bad : {0, -1, -1000000}) {
    SmoothingParameters parameters;
    parameters.iterations = bad;
    try {
      parameters.validate(vcg_core::Method::paper);
      ADD_FAILURE() << "no error for " << bad;
    } catch (const InvalidParameter& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("iterations is " + std::to_string(bad)), std::string::npos) << message;
      EXPECT_NE(message.find("1 or more"), std::string::npos) << message;
    }
  }
}

TEST(SmoothingParameters, NegativeThreadsAreRefused) {
  SmoothingParameters parameters;
  parameters.threads = -1;
  EXPECT_THROW(parameters.validate(vcg_core::Method::paper), InvalidParameter);
}

// The parameters come first: a bad one is named even when the mesh is bad as well, and the progress is not started.
TEST(SmoothingParameters, AreCheckedBeforeAnythingElse) {
  DoubleMesh empty;
  SmoothingParameters parameters;
  parameters.rho = -1;
  bool called = false;
  const auto progress = [&](double, const char*) { return called = true; };
  EXPECT_THROW(vcg_core::smooth(empty, vcg_core::Method::paper, parameters, progress), InvalidParameter);
  EXPECT_FALSE(called);
}

// A weight that has vanished everywhere but at v_i, or a neighbourhood of v_i alone: nothing moves.
TEST(SmoothingParameters, NeighborhoodOfOneVertexMovesNothing) {
  const FlatMesh mesh = potato(1);
  for (const SmoothingPath& path : smoothing_paths())
    for (auto value : {&SmoothingParameters::sigma_c, &SmoothingParameters::sigma_s, &SmoothingParameters::rho}) {
      for (const double tiny : {1e-3, 1e-100, DBL_TRUE_MIN}) {
        SmoothingParameters parameters = path.parameters;
        parameters.*value = tiny;
        // In single precision a weight does not vanish altogether, it stays at 1e-38.
        EXPECT_LE(difference(smoothed(mesh, parameters), mesh, 0).largest, 1e-37) << tiny;
      }
    }
}

// The neighbourhood may be the whole mesh, whose plain mean of heights is then the offset.
TEST(SmoothingParameters, HugeSigmasGiveTheMeanHeight) {
  const FlatMesh mesh = potato(1);
  for (const SmoothingPath& path : smoothing_paths()) {
    SmoothingParameters parameters = path.parameters;
    parameters.sigma_c = parameters.sigma_s = parameters.sigma_n = 1e9;
    const FlatMesh result = smoothed(mesh, parameters);
    const NaiveReference reference(mesh);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < mesh.points.size(); ++j)
        sum += reference.normal(j) * (mesh.points[i] - mesh.points[j]);
      const Point expected = mesh.points[i] - reference.normal(i) * (sum / static_cast<double>(mesh.points.size()));
      EXPECT_LT((result.points[i] - expected).Norm(), path.position_tolerance * reference.average_edge_length());
    }
  }
}

}  // namespace
