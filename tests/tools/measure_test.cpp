// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/measure.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <measure/closest_point.h>
#include <mesh_tools/noise.h>
#include <mesh_tools/random.h>
#include <mesh_tools/shapes.h>

namespace {

using mesh_tools::Measurement;
using mesh_tools::Mesh;

constexpr double pi = 3.14159265358979323846;

Mesh mesh_of(const std::vector<vcg::Point3d>& points, const std::vector<std::array<std::size_t, 3>>& faces) {
  Mesh mesh;
  auto vertex = vcg::tri::Allocator<Mesh>::AddVertices(mesh, points.size());
  for (const vcg::Point3d& p : points) (vertex++)->P() = p;
  for (const auto& f : faces) vcg::tri::Allocator<Mesh>::AddFace(mesh, f[0], f[1], f[2]);
  return mesh;
}

template <class Move>
Mesh moved(const char* shape, std::size_t vertices, Move move) {
  Mesh mesh = mesh_tools::make_shape(shape, vertices);
  for (auto& vertex : mesh.vert) vertex.P() = move(vertex.cP());
  return mesh;
}

/// Two triangles over the edge from (0,0,0) to (0,1,0); the right one is raised by an angle.
Mesh hinge(double degrees) {
  const double a = degrees * pi / 180;
  return mesh_of({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(a), 0, std::sin(a)}}, {{0, 1, 2}, {0, 3, 1}});
}

TEST(Measure, a_mesh_against_itself_is_zero) {
  const Mesh mesh = mesh_tools::make_shape("cad_part", 2000);
  const Measurement figures = mesh_tools::measure(mesh, mesh, &mesh);
  EXPECT_EQ(figures.vertices, mesh.vert.size());
  EXPECT_EQ(figures.faces, mesh.face.size());
  EXPECT_EQ(figures.normal_error.faces, mesh.face.size());
  EXPECT_EQ(figures.normal_error.mean, 0);
  EXPECT_EQ(figures.normal_error.percentile_95, 0);
  EXPECT_GT(figures.sharp_normal_error.faces, 100u);
  EXPECT_EQ(figures.distance_max, 0);
  EXPECT_EQ(figures.reverse_distance_max, 0);
  EXPECT_EQ(*figures.volume_change_percent, 0);
  EXPECT_EQ(figures.flipped_faces, 0u);
  EXPECT_EQ(figures.true_tangential_drift, 0);
  EXPECT_EQ(*figures.tangential_drift, 0);
}

TEST(Measure, normal_errors_by_hand) {
  const Measurement figures = mesh_tools::measure(hinge(20), hinge(0));
  EXPECT_EQ(figures.normal_error.faces, 2u);
  EXPECT_NEAR(figures.normal_error.mean, 10, 1e-12) << "one face at 0, one at 20 degrees";
  EXPECT_NEAR(figures.normal_error.median, 10, 1e-12);
  EXPECT_NEAR(figures.normal_error.percentile_95, 19, 1e-12) << "linear between the sorted values";
}

TEST(Measure, sharp_edges_are_the_references_and_over_30_degrees) {
  EXPECT_EQ(mesh_tools::measure(hinge(0), hinge(29.9)).sharp_normal_error.faces, 0u);
  EXPECT_EQ(mesh_tools::measure(hinge(0), hinge(30.1)).sharp_normal_error.faces, 2u);
  EXPECT_EQ(mesh_tools::measure(hinge(90), hinge(0)).sharp_normal_error.faces, 0u);
  EXPECT_NEAR(mesh_tools::measure(hinge(0), hinge(40)).sharp_normal_error.mean, 20, 1e-12);
}

TEST(Measure, faces_that_touch_a_sharp_edge_with_one_vertex_count) {
  // The hinge with a third triangle that shares only the vertex (0, 0, 0) with the others.
  const auto with_flap = [](double degrees) {
    const double a = degrees * pi / 180;
    return mesh_of({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(a), 0, std::sin(a)}, {-1, -1, 0}, {0, -1, 0}},
                   {{0, 1, 2}, {0, 3, 1}, {0, 4, 5}});
  };
  EXPECT_EQ(mesh_tools::measure(with_flap(0), with_flap(45)).sharp_normal_error.faces, 3u);
}

TEST(Measure, flipped_faces_are_turned_by_more_than_90_degrees) {
  EXPECT_EQ(mesh_tools::measure(hinge(89), hinge(0)).flipped_faces, 0u);
  EXPECT_EQ(mesh_tools::measure(hinge(91), hinge(0)).flipped_faces, 1u);
}

TEST(Measure, faces_without_area_are_counted_and_left_out) {
  const Mesh good = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
  const Mesh bad = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 2}, {1, 3, 2}});
  const Measurement figures = mesh_tools::measure(bad, good);
  EXPECT_EQ(figures.degenerate_faces, 1u);
  EXPECT_EQ(figures.normal_error.faces, 1u);
  EXPECT_EQ(figures.normal_error.mean, 0);
}

TEST(Measure, distances_of_a_plane_that_was_lifted) {
  const Mesh plane = mesh_tools::make_shape("plane_alternating", 400);
  const Mesh lifted = moved("plane_alternating", 400, [](vcg::Point3d p) { return p + vcg::Point3d(0, 0, 0.01); });
  const double e = mesh_tools::average_edge_length(plane);
  const Measurement figures = mesh_tools::measure(lifted, plane, &plane);
  EXPECT_NEAR(figures.average_edge_length, e, 1e-15);
  EXPECT_NEAR(figures.distance_rms, 0.01 / e, 1e-12);
  EXPECT_NEAR(figures.distance_max, 0.01 / e, 1e-12);
  EXPECT_NEAR(figures.reverse_distance_rms, 0.01 / e, 1e-12);
  EXPECT_FALSE(figures.volume_change_percent.has_value()) << "a plane has no volume";
  EXPECT_NEAR(*figures.tangential_drift, 0, 1e-15);
  EXPECT_NEAR(figures.normal_error.mean, 0, 1e-10);
}

/// One vertex in the middle of a plane is pulled up by h: only it is off the reference, and the reference's vertex
/// below it is closest to the flanks of the peak.
TEST(Measure, the_two_directions_of_the_distance_differ_as_they_should) {
  const Mesh plane = mesh_tools::make_shape("plane_slash", 121);
  Mesh peak = mesh_tools::make_shape("plane_slash", 121);
  const double h = 0.05, step = 0.1, e = mesh_tools::average_edge_length(plane);
  peak.vert[60].P()[2] = h;
  const Measurement figures = mesh_tools::measure(peak, plane);
  EXPECT_NEAR(figures.distance_max, h / e, 1e-12);
  EXPECT_NEAR(figures.distance_rms, h / e / std::sqrt(121.0), 1e-12);
  // Around the vertex of a '/' grid the flanks rise over a hexagon, whose nearest sides are the diagonals' cut corners.
  const double foot = step / std::sqrt(2.0), flank = foot * h / std::hypot(foot, h);
  EXPECT_NEAR(figures.reverse_distance_max, flank / e, 1e-9);
}

TEST(Measure, tangential_drift_is_what_slides) {
  const Mesh plane = mesh_tools::make_shape("plane_slash", 400);
  const Mesh slid = moved("plane_slash", 400, [](vcg::Point3d p) { return p + vcg::Point3d(0.003, 0.004, 0.1); });
  const double e = mesh_tools::average_edge_length(plane);
  const Measurement figures = mesh_tools::measure(slid, plane, &plane);
  EXPECT_NEAR(figures.true_tangential_drift, 0.005 / e, 1e-12);
  EXPECT_NEAR(*figures.tangential_drift, 0.005 / e, 1e-12);
  EXPECT_FALSE(mesh_tools::measure(slid, plane).tangential_drift.has_value());
}

TEST(Measure, volume_change_of_a_scaled_cube) {
  const Mesh cube = mesh_tools::make_shape("cube", 500);
  const Mesh larger = moved("cube", 500, [](vcg::Point3d p) { return p * 1.1; });
  EXPECT_NEAR(*mesh_tools::measure(larger, cube).volume_change_percent, 33.1, 1e-9);
  EXPECT_NEAR(*mesh_tools::measure(cube, larger).volume_change_percent, 100 / 1.331 - 100, 1e-9);
}

TEST(Measure, figures_do_not_depend_on_place_and_scale) {
  Mesh noisy = mesh_tools::make_shape("cad_part", 2000);
  mesh_tools::add_noise(noisy, 0.2, 1, mesh_tools::NoiseDirection::any);
  const Mesh clean = mesh_tools::make_shape("cad_part", 2000);
  const Measurement here = mesh_tools::measure(noisy, clean);
  const auto far_and_large = [](Mesh& mesh) {
    for (auto& vertex : mesh.vert) vertex.P() = vertex.cP() * 1000.0 + vcg::Point3d(1e6, -2e6, 3e6);
  };
  Mesh there_noisy = mesh_tools::make_shape("cad_part", 2000), there_clean = mesh_tools::make_shape("cad_part", 2000);
  mesh_tools::add_noise(there_noisy, 0.2, 1, mesh_tools::NoiseDirection::any);
  far_and_large(there_noisy);
  far_and_large(there_clean);
  const Measurement there = mesh_tools::measure(there_noisy, there_clean);
  EXPECT_NEAR(there.normal_error.mean, here.normal_error.mean, 1e-5);
  EXPECT_NEAR(there.distance_rms, here.distance_rms, 1e-6);
  EXPECT_NEAR(there.reverse_distance_max, here.reverse_distance_max, 1e-6);
  EXPECT_NEAR(*there.volume_change_percent, *here.volume_change_percent, 1e-4);
  EXPECT_EQ(there.sharp_normal_error.faces, here.sharp_normal_error.faces);
}

TEST(Measure, does_not_depend_on_the_number_of_threads) {
  Mesh noisy = mesh_tools::make_shape("cube", 10000);
  mesh_tools::add_noise(noisy, 0.3, 1, mesh_tools::NoiseDirection::normal);
  const Mesh clean = mesh_tools::make_shape("cube", 10000);
  const Measurement one = mesh_tools::measure(noisy, clean, nullptr, 1),
                    three = mesh_tools::measure(noisy, clean, nullptr, 3);
  EXPECT_EQ(one.distance_rms, three.distance_rms);
  EXPECT_EQ(one.reverse_distance_rms, three.reverse_distance_rms);
}

TEST(Measure, refuses_other_connectivity) {
  const Mesh a = mesh_tools::make_shape("cube", 500), b = mesh_tools::make_shape("cube", 600);
  EXPECT_THROW(mesh_tools::measure(a, b), mesh_tools::DifferentConnectivity);
  EXPECT_THROW(mesh_tools::measure(a, a, &b), mesh_tools::DifferentConnectivity);
  Mesh turned = mesh_tools::make_shape("cube", 500);
  std::swap(turned.face[7].V(0), turned.face[7].V(1));
  try {
    mesh_tools::measure(turned, a);
    FAIL() << "must throw";
  } catch (const mesh_tools::DifferentConnectivity& error) {
    EXPECT_NE(std::string(error.what()).find("face 7"), std::string::npos) << error.what();
  }
}

TEST(Measure, refuses_meshes_without_faces_or_with_bad_coordinates) {
  const Mesh cube = mesh_tools::make_shape("cube", 500);
  const Mesh points = mesh_of({{0, 0, 0}, {1, 0, 0}}, {});
  EXPECT_THROW(mesh_tools::measure(points, points), std::invalid_argument);
  Mesh broken = mesh_tools::make_shape("cube", 500);
  broken.vert[3].P()[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mesh_tools::measure(broken, cube), std::invalid_argument);
  EXPECT_THROW(mesh_tools::measure(cube, broken), std::invalid_argument);
}

/// The tree against all triangles one by one, and the triangle against a fine sampling of itself.
TEST(SurfaceDistance, agrees_with_all_pairs) {
  const Mesh mesh = mesh_tools::make_shape("graded_cube", 600);
  const mesh_tools::SurfaceDistance distance(mesh);
  mesh_tools::Random random(3);
  for (int i = 0; i < 300; ++i) {
    const vcg::Point3d p(3 * random.uniform() - 1, 3 * random.uniform() - 1, 3 * random.uniform() - 1);
    double best = 1e300;
    for (const auto& face : mesh.face)
      best = std::min(best, mesh_tools::squared_distance_to_triangle(p, {face.cP(0), face.cP(1), face.cP(2)}));
    EXPECT_DOUBLE_EQ(distance(p, 1e3), std::sqrt(best));
  }
}

TEST(SurfaceDistance, to_a_triangle_in_all_its_regions) {
  mesh_tools::Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    std::array<vcg::Point3d, 3> t;
    for (vcg::Point3d& corner : t) corner = random.direction() * random.uniform();
    const vcg::Point3d p = random.direction() * 2 * random.uniform();
    const double exact = std::sqrt(mesh_tools::squared_distance_to_triangle(p, t));
    double sampled = 1e300;
    constexpr int n = 100;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        sampled = std::min(sampled, (p - (t[0] * i + t[1] * j + t[2] * (n - i - j)) / n).Norm());
    EXPECT_LE(exact, sampled + 1e-12);
    EXPECT_GT(exact, sampled - 2.0 / n);
  }
}

TEST(SurfaceDistance, to_a_triangle_without_area_is_that_to_its_edges) {
  const std::array<vcg::Point3d, 3> line{vcg::Point3d(0, 0, 0), vcg::Point3d(2, 0, 0), vcg::Point3d(1, 0, 0)};
  EXPECT_DOUBLE_EQ(mesh_tools::squared_distance_to_triangle({1.5, 3, 0}, line), 9);
  EXPECT_DOUBLE_EQ(mesh_tools::squared_distance_to_triangle({4, 0, 0}, line), 4);
}

}  // namespace
