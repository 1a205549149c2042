// SPDX-License-Identifier: GPL-3.0-or-later
// Geodesic distances on finer and finer spheres approach the great circle's.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <vcg_core/geodesic_distance.h>

namespace {

using namespace test_support;

struct Errors {
  double root_mean_square = 0;
  double largest = 0;
};

Errors errors_on_sphere(int levels, std::size_t source) {
  const FlatMesh sphere = icosphere(levels);
  DoubleMesh mesh;
  fill(mesh, sphere);
  const std::vector<double> distance = vcg_core::geodesic_distances(mesh, source);
  Errors errors;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const double chord = (sphere.points[v] - sphere.points[source]).Norm();
    const double error = std::abs(distance[v] - 2 * std::asin(std::min(1.0, chord / 2)));
    errors.largest = std::max(errors.largest, error);
    errors.root_mean_square += error * error / static_cast<double>(distance.size());
  }
  errors.root_mean_square = std::sqrt(errors.root_mean_square);
  return errors;
}

TEST(SphereGeodesics, ErrorShrinksWithEveryRefinement) {
  for (const std::size_t source : {0u, 13u}) {
    Errors last = errors_on_sphere(2, source);
    for (int levels = 3; levels <= 6; ++levels) {
      const Errors errors = errors_on_sphere(levels, source);
      RecordProperty("level_" + std::to_string(levels) + "_from_" + std::to_string(source),
                     std::to_string(errors.root_mean_square) + " rms, " + std::to_string(errors.largest) + " max");
      // Edges half as long: of first order in the mean, nearly so at the worst vertex, which lies opposite.
      EXPECT_LT(errors.root_mean_square, 0.55 * last.root_mean_square) << levels;
      EXPECT_LT(errors.largest, 0.62 * last.largest) << levels;
      last = errors;
    }
  }
}

}  // namespace
