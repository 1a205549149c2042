// SPDX-License-Identifier: GPL-3.0-or-later
// The noise estimate against noise that is known, and on shapes without any.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <job.h>
#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>
#include <support/arrays_of.h>
#include <support/clean_shapes.h>
#include <support/mesh_types.h>

#include "filters/guided/noise_estimate.h"

namespace {

using namespace vcg_core::detail;
using mesh_tools::NoiseDirection;
using test_support::FlatMesh;
using test_support::Point;

const vcg_core::Progress no_progress;

struct Found {
  NoiseEstimate noise;
  MeshArrays mesh;
};

Found found_on(const FlatMesh& flat, int threads = 1) {
  Job job{no_progress, threads};
  Found found{{}, test_support::arrays_of(flat, job)};
  found.noise = estimate_noise(found.mesh, RingMeans(found.mesh, job), found.mesh.position, job);
  return found;
}

/// The estimate over the whole mesh, in the unit of `flat`.
double estimated(const FlatMesh& flat) {
  const Found found = found_on(flat);
  return std::ldexp(found.noise.mean, -found.mesh.exponent);
}

struct Shape {
  FlatMesh mesh;
  double edge;                        ///< |e|
  std::vector<vcg::Point3d> normals;  ///< of the vertices
};

Shape shape_of(const char* name, std::size_t vertices) {
  const mesh_tools::Mesh mesh = mesh_tools::make_shape(name, vertices);
  return {test_support::flat(mesh), mesh_tools::average_edge_length(mesh), mesh_tools::vertex_normals(mesh)};
}

FlatMesh with_noise(const char* name, std::size_t vertices, double level, NoiseDirection direction) {
  mesh_tools::Mesh mesh = mesh_tools::make_shape(name, vertices);
  mesh_tools::add_noise(mesh, level, 11, direction);
  return test_support::flat(mesh);
}

TEST(NoiseEstimate, IsThatOfTheNoiseAlongTheNormals) {
  for (const char* name : {"cube", "sphere", "cad_part", "torus", "thin_sheets", "stepped_block"})
    for (const double level : {0.1, 0.2, 0.3, 0.5}) {
      const double truth = level * shape_of(name, 8000).edge;
      EXPECT_NEAR(estimated(with_noise(name, 8000, level, NoiseDirection::normal)), truth, 0.2 * truth)
          << name << " " << level;
    }
}

// A third of the variance of noise in any direction is along the normals.
TEST(NoiseEstimate, IsThePartAlongTheNormalsOfNoiseInAnyDirection) {
  for (const char* name : {"cube", "sphere", "cad_part", "thin_sheets"})
    for (const double level : {0.2, 0.3, 0.5}) {
      const double truth = level * shape_of(name, 8000).edge / std::sqrt(3.0);
      EXPECT_NEAR(estimated(with_noise(name, 8000, level, NoiseDirection::any)), truth, 0.2 * truth)
          << name << " " << level;
    }
}

// Its standard deviation over all vertices, of which four fifths do not move.
TEST(NoiseEstimate, SeesImpulses) {
  for (const char* name : {"sphere", "cube", "cad_part"})
    for (const double level : {0.2, 0.5}) {
      Shape shape = shape_of(name, 8000);
      std::mt19937 random(3);
      std::normal_distribution<double> normal;
      std::uniform_real_distribution<double> uniform;
      for (std::size_t v = 0; v < shape.mesh.points.size(); ++v)
        if (uniform(random) < 0.2) shape.mesh.points[v] += shape.normals[v] * (normal(random) * level * shape.edge);
      const double truth = level * shape.edge * std::sqrt(0.2);
      EXPECT_NEAR(estimated(shape.mesh), truth, 0.2 * truth) << name << " " << level;
    }
}

/// Asks for an estimate within a quarter of the root mean square of the moves along the normals.
void expect_estimate(const char* name, const char* kind, const mesh_tools::NoiseModel& model) {
  const Shape clean = shape_of(name, 6000);
  mesh_tools::Mesh mesh = mesh_tools::make_shape(name, 6000);
  mesh_tools::add_noise(mesh, model);
  double squares = 0;
  for (std::size_t v = 0; v < clean.normals.size(); ++v) {
    const double along = (mesh.vert[v].cP() - clean.mesh.points[v]) * clean.normals[v];
    squares += along * along / static_cast<double>(clean.normals.size());
  }
  const double truth = std::sqrt(squares);
  EXPECT_NEAR(estimated(test_support::flat(mesh)), truth, 0.25 * truth) << name << " " << kind;
}

TEST(NoiseEstimate, IsThatOfScanners) {
  mesh_tools::NoiseModel impulsive;
  impulsive.level = 0.5;
  impulsive.share = 1.0 / 3;
  mesh_tools::NoiseModel uneven;
  uneven.level = 0.05;
  uneven.level_far = 0.4;
  uneven.axis = vcg::Point3d(1, 2, 3);
  mesh_tools::NoiseModel steps;
  steps.step = 0.5;
  steps.axis = vcg::Point3d(1, 2, 3);
  for (const char* name : {"cube", "sphere", "cad_part", "torus"}) {
    expect_estimate(name, "impulsive", impulsive);
    expect_estimate(name, "uneven", uneven);
    expect_estimate(name, "steps", steps);
  }
  mesh_tools::NoiseModel depth;
  depth.level = 0.2;
  depth.camera = vcg::Point3d(0.3, 0.2, 1.5);
  for (const char* name : {"plane_random_diagonals", "thin_sheets"}) expect_estimate(name, "depth camera", depth);
}

TEST(NoiseEstimate, FollowsNoiseThatDiffersOverTheMesh) {
  for (const char* name : {"sphere", "torus", "cube"}) {
    Shape shape = shape_of(name, 20000);
    const double level = 0.2 * shape.edge;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    double middle = 0;
    for (const Point& p : shape.mesh.points) middle += p[0] / static_cast<double>(shape.mesh.points.size());
    for (std::size_t v = 0; v < shape.mesh.points.size(); ++v)
      if (shape.mesh.points[v][0] > middle) shape.mesh.points[v] += shape.normals[v] * (normal(random) * level);
    const Found found = found_on(shape.mesh);
    double noisy = 0, clean = 0;
    std::size_t noisy_count = 0, clean_count = 0;
    for (std::size_t v = 0; v < found.mesh.size(); ++v) {
      const double x = std::ldexp(found.mesh.position[v][0], -found.mesh.exponent) - middle;
      const double deviation = std::ldexp(found.noise.deviation[v], -found.mesh.exponent);
      if (x > 0.4) noisy += deviation * deviation, ++noisy_count;
      if (x < -0.4) clean = std::max(clean, deviation), ++clean_count;
    }
    ASSERT_GT(noisy_count, 1000u);
    ASSERT_GT(clean_count, 1000u);
    EXPECT_NEAR(std::sqrt(noisy / static_cast<double>(noisy_count)), level, 0.2 * level) << name;
    EXPECT_LT(clean, 0.05 * level) << name;
  }
}

TEST(NoiseEstimate, IsNextToNothingOnCleanShapes) {
  for (const test_support::CleanShape& shape : test_support::clean_shapes())
    EXPECT_LT(estimated(shape.mesh), 0.02 * test_support::average_edge_length(shape.mesh)) << shape.name;
}

TEST(NoiseEstimate, HasEvidenceWhereThereIsNoise) {
  EXPECT_GT(found_on(with_noise("sphere", 3000, 0.2, NoiseDirection::normal)).noise.evidence, 0.9);
  EXPECT_EQ(found_on(shape_of("cube", 3000).mesh).noise.evidence, 0);
}

TEST(NoiseEstimate, DoesNotDependOnTheNumberOfThreads) {
  const FlatMesh mesh = with_noise("cad_part", 20000, 0.2, NoiseDirection::normal);
  EXPECT_EQ(found_on(mesh, 1).noise.deviation, found_on(mesh, 4).noise.deviation);
}

}  // namespace
