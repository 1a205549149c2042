// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/self_intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vcg/complex/complex.h>

#include <vcg/complex/algorithms/clean.h>  // needs complex.h before it

#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/noisy_shapes.h>
#include <support/raw_snapshot.h>
#include <vcg_core/errors.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;

template <class Mesh = DoubleMesh>
std::size_t count(const FlatMesh& shape, int threads = 2) {
  Mesh mesh;
  fill(mesh, shape);
  return vcg_core::count_self_intersections(mesh, {}, threads);
}

/// In no special direction, so that coordinates are rounded.
FlatMesh turned(const FlatMesh& mesh) {
  return transformed(mesh, [](const Point& p) {
    const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(0.3), t = std::sin(0.3);
    const Point q(c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]);
    return Point(q[0], d * q[1] - t * q[2], t * q[1] + d * q[2]) + Point(0.1, 0.2, 0.3);
  });
}

FlatMesh tetrahedron(const Point& a, const Point& b, const Point& c, const Point& d) {
  return {{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

// A peak through the floor of a larger tetrahedron: its three sides and the floor.
FlatMesh crossing_tetrahedra() {
  FlatMesh mesh = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  append(mesh, tetrahedron({0.4, 0.4, -1}, {0.7, 0.4, -1}, {0.4, 0.7, -1}, {0.5, 0.5, 0.5}));
  return mesh;
}

TEST(SelfIntersections, OfCrossingTetrahedra) {
  EXPECT_EQ(count(crossing_tetrahedra()), 4u);
  EXPECT_EQ(count(turned(crossing_tetrahedra())), 4u);
  EXPECT_EQ(count<FloatMesh>(turned(crossing_tetrahedra())), 4u);
  // Apart, there is none.
  FlatMesh apart = crossing_tetrahedra();
  for (std::size_t v = 4; v < 8; ++v) apart.points[v][2] -= 0.75;
  EXPECT_EQ(count(apart), 0u);
}

// The two tetrahedra in a cube: every face of the one crosses three of the other, edges meet edges in their middles.
TEST(SelfIntersections, OfTheStellaOctangula) {
  FlatMesh star = tetrahedron({1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1});
  append(star, tetrahedron({-1, -1, -1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}));
  EXPECT_EQ(count(star), 8u);
  EXPECT_EQ(count(turned(star)), 8u);
}

// Two faces that share one vertex and cross: a bow tie, bent through itself.
TEST(SelfIntersections, OfFacesThatShareAVertex) {
  FlatMesh mesh{{{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {1, 0, -1}, {1, 0, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(count(mesh), 2u);
  EXPECT_EQ(count(turned(mesh)), 2u);
  for (const std::size_t v : {3u, 4u}) mesh.points[v][0] = -1;  // to the other side of the shared vertex
  EXPECT_EQ(count(mesh), 0u);
  EXPECT_EQ(count(turned(mesh)), 0u);
}

TEST(SelfIntersections, AreNoneOnCleanMeshes) {
  for (const FlatMesh& mesh : {cube(), octahedron(), icosphere(4), grid(30), potato(3)}) {
    EXPECT_EQ(count(mesh), 0u);
    EXPECT_EQ(count(turned(mesh)), 0u);
    EXPECT_EQ(count<FloatMesh>(turned(mesh)), 0u);
  }
  for (const std::string& name : shape_names()) {
    SCOPED_TRACE(name);
    const FlatMesh mesh = noisy_shape(name, 3000, 0);
    EXPECT_EQ(count(mesh), 0u);
    EXPECT_EQ(count(turned(mesh)), 0u);
    EXPECT_EQ(count<FloatMesh>(turned(mesh)), 0u);
  }
}

/// A regular polygon in z = 0, cut from its middle.
FlatMesh fan(std::size_t sides) {
  FlatMesh mesh{{{0, 0, 0}}, {}};
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(sides);
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
  }
  return mesh;
}

TEST(SelfIntersections, AreNoneInAFanInOnePlane) {
  for (const std::size_t sides : {3u, 64u, 1000u}) {
    EXPECT_EQ(count(fan(sides)), 0u);
    EXPECT_EQ(count(turned(fan(sides))), 0u);
    EXPECT_EQ(count<FloatMesh>(turned(fan(sides))), 0u);
  }
}

// Contact is no crossing: a cube on a cube, with and without common vertices; faces on top of each other; a corner and
// an edge against the middle of a face.
TEST(SelfIntersections, TouchingFacesAreNone) {
  for (const double shift : {0.0, 0.3}) {
    FlatMesh cubes = cube();
    append(cubes, transformed(cube(), [&](const Point& p) { return p + Point(shift, shift / 2, 1); }));
    EXPECT_EQ(count(cubes), 0u) << shift;
    EXPECT_EQ(count(turned(cubes)), 0u) << shift;
    EXPECT_EQ(count<FloatMesh>(turned(cubes)), 0u) << shift;
  }
  FlatMesh twice = grid(4);
  append(twice, grid(4));
  EXPECT_EQ(count(twice), 0u);
  FlatMesh corner = grid(2);
  append(corner, tetrahedron({0.3, 0.6, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}));
  EXPECT_EQ(count(corner), 0u);
  FlatMesh edge = grid(2);
  append(edge, tetrahedron({0.3, 0.6, 0}, {0.4, 0.7, 0}, {1, 0, 1}, {0, 1, 1}));
  EXPECT_EQ(count(edge), 0u);
  EXPECT_EQ(count(turned(edge)), 0u);
}

TEST(SelfIntersections, FacesWithoutAreaAndIsolatedVerticesAreNone) {
  FlatMesh mesh = cube();
  mesh.faces.push_back({0, 0, 6});
  mesh.points.emplace_back(0, 0, -2);
  mesh.points.emplace_back(0, 0, 0);
  mesh.points.emplace_back(0, 0, 2);
  mesh.faces.push_back({8, 9, 10});  // a line through the cube
  mesh.points.emplace_back(1e30, 0, 0);
  EXPECT_EQ(count(mesh), 0u);
}

TEST(SelfIntersections, DoNotDependOnScaleAndThreads) {
  for (const double scale : {1e-12, 1e-3, 1e12}) {
    const FlatMesh mesh = transformed(turned(crossing_tetrahedra()), [&](const Point& p) { return p * scale; });
    EXPECT_EQ(count(mesh), 4u) << scale;
  }
  const FlatMesh rough = noisy_shape("thin_plate", 4000, 1.5);
  const std::size_t one = count(rough, 1);
  EXPECT_GT(one, 100u);
  EXPECT_EQ(count(rough, 3), one);
}

/// Six times the signed volume.
long double volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  using LongPoint = vcg::Point3<long double>;
  const auto at = [&](const Point& p) { return LongPoint::Construct(p) - LongPoint::Construct(a); };
  return (at(b) ^ at(c)) * at(d);
}

/// Whether the edge p-q goes through the inside of a triangle.
bool pierces(const Point& p, const Point& q, const std::array<Point, 3>& t) {
  if (volume(t[0], t[1], t[2], p) * volume(t[0], t[1], t[2], q) >= 0) return false;
  const long double u = volume(p, q, t[0], t[1]), v = volume(p, q, t[1], t[2]), w = volume(p, q, t[2], t[0]);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

/// All pairs, by the edges of each that pierce the other: exact for meshes in no special position.
std::size_t naive_count(const FlatMesh& mesh) {
  const auto corners = [&](const Triangle& f) {
    return std::array<Point, 3>{mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]};
  };
  std::vector<char> hit(mesh.faces.size(), 0);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
    for (std::size_t j = 0; j < mesh.faces.size(); ++j)
      for (int k = 0; i != j && k < 3; ++k) {
        const std::size_t a = mesh.faces[i][k], b = mesh.faces[i][(k + 1) % 3];
        const Triangle& f = mesh.faces[j];
        const bool shared = std::count(f.begin(), f.end(), a) + std::count(f.begin(), f.end(), b) > 0;
        if (!shared && pierces(mesh.points[a], mesh.points[b], corners(f))) hit[i] = hit[j] = 1;
      }
  return static_cast<std::size_t>(std::count(hit.begin(), hit.end(), 1));
}

// Random faces over few vertices, so that many share one or two, of very different sizes.
TEST(SelfIntersections, AgreeWithAllPairsOnRandomSoup) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int round = 0; round < 20; ++round) {
    FlatMesh soup;
    for (int v = 0; v < 120; ++v) {
      Point p(coordinate(random), coordinate(random), coordinate(random));
      soup.points.push_back(v % 3 == 0 ? p : p * 0.1);
    }
    const std::size_t faces = round % 2 ? 40 : 200;
    while (soup.faces.size() < faces) {
      const Triangle f{random() % 120, random() % 120, random() % 120};
      if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0]) soup.faces.push_back(f);
    }
    EXPECT_EQ(count(soup), naive_count(soup)) << round;
  }
}

TEST(SelfIntersections, AgreeWithAllPairsOnNoise) {
  for (const char* const name : {"cad_part", "thin_plate", "graded_cube"}) {
    const FlatMesh mesh = noisy_shape(name, 600, 1);
    const std::size_t expected = naive_count(mesh);
    EXPECT_GT(expected, 10u) << name;
    EXPECT_EQ(count(mesh), expected) << name;
  }
}

/// As vcglib lists them, each face once.
std::size_t count_by_vcglib(const FlatMesh& shape) {
  RichMesh mesh;
  fill(mesh, shape);
  vcg::tri::UpdateBounding<RichMesh>::Box(mesh);
  std::vector<RichFace*> found;
  vcg::tri::Clean<RichMesh>::SelfIntersections(mesh, found);
  std::sort(found.begin(), found.end());
  return static_cast<std::size_t>(std::unique(found.begin(), found.end()) - found.begin());
}

// In no special position, where rounding decides nothing.
TEST(SelfIntersections, AgreeWithVcglibOnCrossingSpheres) {
  for (const double shift : {0.3, 0.7123, 1.9}) {
    FlatMesh spheres = icosphere(4);
    append(spheres, transformed(icosphere(4), [&](const Point& p) { return p + Point(shift, 0.0113, -0.0517); }));
    const std::size_t expected = count_by_vcglib(spheres);
    EXPECT_GT(expected, 20u) << shift;
    EXPECT_EQ(count(spheres), expected) << shift;
  }
}

TEST(SelfIntersections, StandInTheReportIfAskedFor) {
  DoubleMesh mesh;
  fill(mesh, crossing_tetrahedra());
  vcg_core::SmoothingParameters parameters;
  parameters.selected_only = true;  // nothing moves
  EXPECT_FALSE(vcg_core::smooth(mesh, vcg_core::Method::paper, parameters).self_intersections.has_value());
  parameters.check = true;
  const vcg_core::SmoothingReport report = vcg_core::smooth(mesh, vcg_core::Method::paper, parameters);
  EXPECT_EQ(report.self_intersections, 4u);
  const std::vector<std::string> warnings = report.warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find("4 faces of the result cut through other faces"), 0u) << warnings[0];
}

// All boxes of a fan meet at its tip, so it takes seconds.
TEST(SelfIntersections, CanBeCancelled) {
  DoubleMesh mesh;
  fill(mesh, turned(fan(30000)));
  const auto until_it_looks = [](double, const char* stage) {
    return std::string(stage) != "Looking for self-intersections";
  };
  EXPECT_THROW(vcg_core::count_self_intersections(mesh, until_it_looks), vcg_core::Cancelled);
  vcg_core::SmoothingParameters parameters;
  parameters.check = true;
  const RawSnapshot<DoubleMesh> untouched(mesh);
  EXPECT_THROW(vcg_core::smooth(mesh, vcg_core::Method::laplacian, parameters, until_it_looks), vcg_core::Cancelled);
  EXPECT_TRUE(untouched.unchanged());
}

TEST(SelfIntersections, RefuseWhatIsNoMesh) { EXPECT_THROW(count({{{0, 0, 0}}, {}}), vcg_core::InvalidMesh); }

}  // namespace
