// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/voxel_shapes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <measure/closest_point.h>
#include <mesh_tools/measure.h>
#include <mesh_tools/random.h>
#include <mesh_tools/shapes.h>
#include <shapes/voxel_volume.h>

namespace {

using mesh_tools::make_voxel_shape;
using mesh_tools::Mesh;
using mesh_tools::VoxelGrid;
using mesh_tools::VoxelShape;

constexpr double pi = 3.14159265358979323846;

std::vector<std::string> voxel_names() {
  std::vector<std::string> names;
  for (const mesh_tools::Shape& shape : mesh_tools::all_shapes())
    if (shape.is_closed) names.push_back(std::string("voxel_") + shape.name);
  return names;
}

/// Every side is run through once in each direction, and the faces around a vertex are one fan.
void expect_closed_manifold(const Mesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> next;
  std::map<std::size_t, std::size_t> degree;
  for (const auto& face : mesh.face)
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = vcg::tri::Index(mesh, face.cV(k)), b = vcg::tri::Index(mesh, face.cV((k + 1) % 3));
      ASSERT_TRUE(next.insert({{a, b}, vcg::tri::Index(mesh, face.cV((k + 2) % 3))}).second)
          << "side run through twice";
      ++degree[a];
    }
  for (const auto& [side, third] : next) ASSERT_EQ(next.count({side.second, side.first}), 1u) << "border";
  ASSERT_EQ(degree.size(), mesh.vert.size()) << "unused vertices";
  for (const auto& [vertex, faces] : degree) {
    const std::size_t first = next.lower_bound({vertex, 0})->first.second;
    std::size_t reached = 0, current = first;
    do {
      current = next.at({vertex, current});
      ++reached;
    } while (current != first);
    ASSERT_EQ(reached, faces) << "two fans meet";
  }
}

class EveryVoxelShape : public testing::TestWithParam<std::string> {};

TEST_P(EveryVoxelShape, is_closed_and_manifold_and_turned_outwards) {
  for (const double slice_distance : {1.0, 2.5, 6.0})
    for (const double tilt : {0.0, 30.0}) {
      if (GetParam() == "voxel_thin_plate" && slice_distance > 1) continue;
      SCOPED_TRACE(std::to_string(slice_distance) + ", tilted by " + std::to_string(tilt));
      const VoxelShape shape = make_voxel_shape(GetParam(), 3000, {slice_distance, tilt});
      expect_closed_manifold(shape.surface);
      EXPECT_GT(mesh_tools::signed_volume(shape.surface), 0);
    }
}

TEST_P(EveryVoxelShape, has_about_the_wanted_number_of_vertices) {
  for (const std::size_t wanted : {5000u, 10000u}) {
    const double vertices = make_voxel_shape(GetParam(), wanted, {1, 30}).surface.vn;
    // A plate of one or two layers of voxels has no size in between.
    const double tolerance = GetParam() == "voxel_thin_plate" ? 0.5 : 0.05;
    EXPECT_NEAR(vertices, static_cast<double>(wanted), tolerance * static_cast<double>(wanted));
  }
}

/// Half-way between two centres along one axis, at a centre along the two others.
TEST_P(EveryVoxelShape, has_its_vertices_on_the_grid) {
  for (const double slice_distance : {1.0, 3.0}) {
    if (GetParam() == "voxel_thin_plate" && slice_distance > 1) continue;
    const VoxelShape shape = make_voxel_shape(GetParam(), 2000, {slice_distance, 20});
    const vcg::Point3d half(shape.pixel / 2, shape.pixel / 2, shape.pixel * slice_distance / 2);
    const vcg::Point3d origin = shape.surface.vert[0].cP();
    std::array<std::set<bool>, 3> parities;
    for (const auto& vertex : shape.surface.vert)
      for (int axis = 0; axis < 3; ++axis) {
        const double place = (vertex.cP()[axis] - origin[axis]) / half[axis];
        ASSERT_NEAR(place, std::round(place), 1e-9);
        parities[axis].insert(std::lround(place) % 2 != 0);
      }
    for (const auto& parity : parities) EXPECT_EQ(parity.size(), 2u);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryVoxelShape, testing::ValuesIn(voxel_names()),
                         [](const auto& shape) { return shape.param; });

/// The volume of the voxels approaches that of the solid: the error falls with the width of the voxels.
TEST(VoxelShapes, fill_their_solid) {
  for (const double slice_distance : {1.0, 3.0}) {
    const double coarse = make_voxel_shape("voxel_sphere", 1000, {slice_distance, 0}).pixel;
    const double fine = make_voxel_shape("voxel_sphere", 16000, {slice_distance, 0}).pixel;
    EXPECT_NEAR(coarse / fine, 4, 0.2) << "vertices grow with the square of the resolution";
    const Mesh sphere = make_voxel_shape("voxel_sphere", 16000, {slice_distance, 0}).surface;
    EXPECT_NEAR(mesh_tools::signed_volume(sphere), 4 * pi / 3, 0.01 * slice_distance);
    const Mesh torus = make_voxel_shape("voxel_torus", 16000, {slice_distance, 25}).surface;
    EXPECT_NEAR(mesh_tools::signed_volume(torus), 2 * pi * pi * 0.16, 0.03 * slice_distance);
  }
}

TEST(VoxelShapes, tell_the_inside_of_a_mesh_as_the_formula_does) {
  // The solid of a fine mesh of the cube against the cube's formula, in the cube's own frame.
  const mesh_tools::shapes::Solid cube("cube", 500, 0);
  const mesh_tools::shapes::VoxelVolume volume(cube, 0.0731, 1.5);
  for (int k = 0; k < volume.size()[2]; ++k)
    for (int j = 0; j < volume.size()[1]; ++j)
      for (int i = 0; i < volume.size()[0]; ++i) {
        const vcg::Point3d p = volume.centre(i, j, k);
        const bool inside = p[0] > 0 && p[0] < 1 && p[1] > 0 && p[1] < 1 && p[2] > 0 && p[2] < 1;
        ASSERT_EQ(volume.at(i, j, k), inside) << p[0] << " " << p[1] << " " << p[2];
      }
}

TEST(VoxelShapes, have_their_truth_on_the_shape) {
  for (const auto& vertex : make_voxel_shape("voxel_sphere", 2000, {3, 0}).truth.vert)
    EXPECT_NEAR(vertex.cP().Norm(), 1, 1e-14);
  for (const auto& vertex : make_voxel_shape("voxel_torus", 2000).truth.vert) {
    const vcg::Point3d& p = vertex.cP();
    EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]), 0.4, 1e-14);
  }
  for (const auto& vertex : make_voxel_shape("voxel_cube", 2000).truth.vert) {
    double depth = 1;
    for (int axis = 0; axis < 3; ++axis)
      depth = std::min({depth, std::abs(vertex.cP()[axis]), std::abs(1 - vertex.cP()[axis])});
    EXPECT_NEAR(depth, 0, 1e-14);
  }
}

/// What users know of label maps: normals are off by 20 degrees, more the farther the slices are apart, and no vertex
/// is farther from the solid than half of a voxel's diagonal.
TEST(VoxelShapes, are_as_rough_as_label_maps) {
  double last = 0;
  for (const double slice_distance : {1.0, 3.0, 6.0}) {
    const VoxelShape shape = make_voxel_shape("voxel_sphere", 8000, {slice_distance, 0});
    const auto figures = mesh_tools::measure(shape.surface, shape.truth);
    if (slice_distance == 1) {
      EXPECT_NEAR(figures.normal_error.mean, 20.6, 0.7);
    }
    EXPECT_GT(figures.normal_error.mean, last);
    last = figures.normal_error.mean;
    const double largest = shape.pixel * std::sqrt(2 + slice_distance * slice_distance) / 2;
    for (int v = 0; v < shape.surface.vn; ++v)
      EXPECT_LE((shape.surface.vert[v].cP() - shape.truth.vert[v].cP()).Norm(), largest);
    EXPECT_LT(figures.flipped_faces, static_cast<std::size_t>(shape.surface.fn) / 500);
  }
}

TEST(VoxelShapes, are_the_same_every_time) {
  const Mesh a = make_voxel_shape("voxel-cad-part", 3000).surface, b = mesh_tools::make_shape("voxel_cad_part", 3000);
  ASSERT_EQ(a.vn, b.vn);
  ASSERT_EQ(a.fn, b.fn);
  for (int i = 0; i < a.vn; ++i) ASSERT_EQ(a.vert[i].cP(), b.vert[i].cP());
}

TEST(VoxelShapes, refuse_open_shapes_and_bad_grids) {
  for (const char* name : {"voxel_plane_slash", "voxel_thin_sheets", "voxel_", "voxel_voxel_cube", "cube"})
    EXPECT_THROW(make_voxel_shape(name, 1000), std::invalid_argument) << name;
  for (const double distance : {0.99, 6.01, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(make_voxel_shape("voxel_cube", 1000, {distance, 0}), std::invalid_argument) << distance;
  EXPECT_THROW(make_voxel_shape("voxel_cube", 1000, {1, INFINITY}), std::invalid_argument);
  EXPECT_THROW(make_voxel_shape("voxel_thin_plate", 3000, {6, 0}), std::invalid_argument) << "between two slices";
}

/// The nearest point lies on the surface and is as far away as the distance says.
TEST(SurfaceDistance, nearest_point_has_the_distance) {
  const Mesh mesh = mesh_tools::make_shape("cad_part", 2000);
  const mesh_tools::SurfaceDistance surface(mesh);
  mesh_tools::Random random(3);
  for (int i = 0; i < 500; ++i) {
    const vcg::Point3d p(2 * random.uniform() - 0.5, 2 * random.uniform() - 0.5, random.uniform());
    const vcg::Point3d nearest = surface.nearest(p);
    EXPECT_NEAR((p - nearest).Norm(), surface(p, 10), 1e-14);
    EXPECT_NEAR(surface(nearest, 10), 0, 1e-14);
  }
}

}  // namespace
