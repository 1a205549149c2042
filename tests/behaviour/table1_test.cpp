// SPDX-License-Identifier: GPL-3.0-or-later
// Table 1's parameters on real noisy models, against the figures of an independent implementation.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include <support/smoothed.h>
#include <support/smoothing_path.h>
#include <support/test_data.h>

namespace {

using namespace test_support;

constexpr double degrees_per_radian = 57.29577951308232;

Point face_normal(const FlatMesh& mesh, const Triangle& f) {
  const Point cross = (mesh.points[f[1]] - mesh.points[f[0]]) ^ (mesh.points[f[2]] - mesh.points[f[0]]);
  return cross / cross.Norm();
}

/// Mean over the faces of the angle between the normals of two meshes of the same faces, in degrees.
double mean_normal_error(const FlatMesh& a, const FlatMesh& b) {
  double sum = 0;
  for (const Triangle& f : a.faces)
    sum += std::acos(std::clamp(face_normal(a, f) * face_normal(b, f), -1.0, 1.0)) * degrees_per_radian;
  return sum / static_cast<double>(a.faces.size());
}

class Table1 : public testing::TestWithParam<SmoothingPath> {};

TEST_P(Table1, OnTheNoisyFandisk) {
  const auto model = load_model("Fandisk0.3");
  if (!model) GTEST_SKIP() << "no model Fandisk0.3 in ANISO_TEST_DATA";
  EXPECT_NEAR(mean_normal_error(model->noisy, model->original), 28.42, 0.01);
  const FlatMesh result = smoothed(model->noisy, GetParam().parameters);
  const double error = mean_normal_error(result, model->original);
  RecordProperty("degrees", std::to_string(error));
  EXPECT_NEAR(error, 10.05, 0.1);
}

TEST_P(Table1, HalvesTheErrorOfEveryModel) {
  for (const std::string& name : model_names()) {
    const auto model = load_model(name);
    if (!model) GTEST_SKIP() << "no model " << name << " in ANISO_TEST_DATA";
    const double before = mean_normal_error(model->noisy, model->original);
    const double after = mean_normal_error(smoothed(model->noisy, GetParam().parameters), model->original);
    RecordProperty(name, std::to_string(before) + " to " + std::to_string(after));
    EXPECT_LT(after, 0.5 * before) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, Table1, testing::ValuesIn(smoothing_paths()), name_of_path);

}  // namespace
