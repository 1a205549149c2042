// SPDX-License-Identifier: GPL-3.0-or-later
// Grids of voxels are found on surfaces that were made of them, and on nothing else.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <job.h>
#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>
#include <mesh_tools/voxel_shapes.h>
#include <support/arrays_of.h>
#include <support/clean_shapes.h>

#include "filters/guided/voxel_stairs.h"

namespace {

using namespace vcg_core::detail;
using test_support::FlatMesh;
using test_support::Point;

const vcg_core::Progress no_progress;

struct Found {
  MeshArrays mesh;
  std::optional<VoxelStairs> stairs;
};

Found found_on(const FlatMesh& flat) {
  Job job{no_progress, 1};
  Found found{test_support::arrays_of(flat, job), std::nullopt};
  found.stairs = find_voxel_stairs(found.mesh, job);
  return found;
}

void expect_steps(const VoxelStairs& stairs, double x, double y, double z) {
  EXPECT_NEAR(stairs.step[0], x, 1e-4 * x);
  EXPECT_NEAR(stairs.step[1], y, 1e-4 * y);
  EXPECT_NEAR(stairs.step[2], z, 1e-4 * z);
}

TEST(VoxelStairs, HaveTheStepsOfTheirGrid) {
  for (const char* name : {"voxel_sphere", "voxel_torus", "voxel_cube"})
    for (const double slice_distance : {1.0, 1.7, 6.0})
      for (const double tilt : {0.0, 20.0}) {
        const auto shape = mesh_tools::make_voxel_shape(name, 2000, {slice_distance, tilt});
        const Found found = found_on(test_support::flat(shape.surface));
        ASSERT_TRUE(found.stairs) << name << " " << slice_distance << " " << tilt;
        expect_steps(*found.stairs, shape.pixel, shape.pixel, slice_distance * shape.pixel);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.stairs->axis[k][k], 1, 1e-9);
      }
}

/// As files have them: single precision, in millimetres, away from the origin.
TEST(VoxelStairs, AreFoundThroughTheRoundingOfFiles) {
  const auto shape = mesh_tools::make_voxel_shape("voxel_torus", 20000, {2.5, 0});
  const auto stored = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const FlatMesh mesh = test_support::transformed(test_support::flat(shape.surface), [&](const Point& p) {
    return Point(stored(100 * p[0] - 200), stored(100 * p[1] + 700), stored(100 * p[2] - 1500));
  });
  const Found found = found_on(mesh);
  ASSERT_TRUE(found.stairs);
  expect_steps(*found.stairs, 100 * shape.pixel, 100 * shape.pixel, 250 * shape.pixel);
}

/// An oblique scan: the axes turn with the mesh.
TEST(VoxelStairs, AreFoundAlongAnyAxes) {
  const auto shape = mesh_tools::make_voxel_shape("voxel_cad_part", 5000, {3, 15});
  const double c = std::cos(0.4), s = std::sin(0.4);
  const auto turned = [&](const Point& p) {  // about z, then about x
    const Point q(c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]);
    return Point(q[0], c * q[1] - s * q[2], s * q[1] + c * q[2]);
  };
  const auto stored = [&](const Point& p) {
    const vcg::Point3f q(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
    return Point(q[0], q[1], q[2]);
  };
  const Found found = found_on(
      test_support::transformed(test_support::flat(shape.surface), [&](const Point& p) { return stored(turned(p)); }));
  ASSERT_TRUE(found.stairs);
  expect_steps(*found.stairs, shape.pixel, shape.pixel, 3 * shape.pixel);
  for (int k = 0; k < 3; ++k) {
    Point axis(0, 0, 0);
    axis[k] = 1;
    axis = turned(axis);
    EXPECT_NEAR(found.stairs->axis[k].dot(Vec3(axis[0], axis[1], axis[2])), 1, 1e-9);
  }
}

/// The sphere's surface passes between the centres of the two voxels of each vertex.
TEST(VoxelStairs, TellBetweenWhichVoxelsEachVertexIs) {
  const auto shape = mesh_tools::make_voxel_shape("voxel_sphere", 8000, {3, 0});
  const Found found = found_on(test_support::flat(shape.surface));
  ASSERT_TRUE(found.stairs);
  for (std::size_t v = 0; v < found.mesh.size(); ++v) {
    const std::uint8_t k = found.stairs->pair[v];
    ASSERT_LT(k, 3);
    const Vec3 half = found.stairs->axis[k] * (found.stairs->step[k] / 2);
    EXPECT_NE((found.mesh.position[v] - half).norm() < 1, (found.mesh.position[v] + half).norm() < 1) << v;
  }
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Against the true distances of the vertices from the shape.
TEST(VoxelStairs, TellHowFarVerticesAreFromTheShape) {
  for (const char* name : {"voxel_sphere", "voxel_torus", "voxel_cad_part"})
    for (const double slice_distance : {1.0, 3.0, 6.0}) {
      const auto shape = mesh_tools::make_voxel_shape(name, 4000, {slice_distance, 15});
      Job job{no_progress, 1};
      const MeshArrays mesh = test_support::arrays_of(test_support::flat(shape.surface), job);
      const std::optional<VoxelStairs> stairs = find_voxel_stairs(mesh, job);
      ASSERT_TRUE(stairs);
      const Array<double> found = deviations_by_stairs(mesh, RingMeans(mesh, job), *stairs, job);
      std::vector<double> truth;
      for (int v = 0; v < shape.surface.vn; ++v)
        truth.push_back((shape.surface.vert[v].cP() - shape.truth.vert[v].cP()).Norm());
      const double expected = std::ldexp(root_mean_square(truth), mesh.exponent);
      EXPECT_NEAR(root_mean_square({found.begin(), found.end()}), expected, 0.2 * expected)
          << name << " " << slice_distance;
    }
}

TEST(VoxelStairs, AreNotFoundOnCleanShapes) {
  for (const test_support::CleanShape& shape : test_support::clean_shapes())
    EXPECT_FALSE(found_on(shape.mesh).stairs) << shape.name;
  for (const mesh_tools::Shape& shape : mesh_tools::all_shapes())
    EXPECT_FALSE(found_on(test_support::flat(mesh_tools::make_shape(shape.name, 2000))).stairs) << shape.name;
}

/// Models on exact grids, which have levels along all axes: a terrain of whole heights, a cube of squares.
TEST(VoxelStairs, AreNotFoundOnCleanGrids) {
  constexpr std::size_t side = 30;
  FlatMesh terrain;
  for (std::size_t i = 0; i < side; ++i)
    for (std::size_t j = 0; j < side; ++j)
      terrain.points.emplace_back(
          static_cast<double>(i), static_cast<double>(j),
          std::round(3 * std::sin(0.3 * static_cast<double>(i)) + 0.2 * static_cast<double>(j)));
  for (std::size_t i = 0; i + 1 < side; ++i)
    for (std::size_t j = 0; j + 1 < side; ++j) {
      const std::size_t v = i * side + j;
      terrain.faces.push_back({v, v + side, v + side + 1});
      terrain.faces.push_back({v, v + side + 1, v + 1});
    }
  EXPECT_FALSE(found_on(terrain).stairs);
  FlatMesh cube = test_support::prism(test_support::polygon(4), false);
  for (int split = 0; split < 4; ++split) cube = test_support::split_in_four(cube);
  EXPECT_FALSE(found_on(cube).stairs);
}

TEST(VoxelStairs, AreNotFoundUnderNoise) {
  for (const char* name : {"sphere", "cube", "voxel_sphere", "voxel_cube"}) {
    mesh_tools::Mesh mesh = mesh_tools::make_shape(name, 3000);
    mesh_tools::add_noise(mesh, 0.2, 1, mesh_tools::NoiseDirection::normal);
    EXPECT_FALSE(found_on(test_support::flat(mesh)).stairs) << name;
  }
}

}  // namespace
