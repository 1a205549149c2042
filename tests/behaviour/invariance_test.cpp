// SPDX-License-Identifier: GPL-3.0-or-later
// The result moves with the mesh, and does not know where, how large or in which order it was given.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <mesh_tools/random.h>
#include <support/comparison.h>
#include <support/hand_made.h>
#include <support/noisy_shapes.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>

namespace {

using namespace test_support;

class Invariance : public testing::TestWithParam<SmoothingPath> {
 protected:
  /// Compares the result for a changed mesh, changed back, with that for the mesh itself.
  void expect_same(const FlatMesh& changed, const std::function<Point(const Point&)>& back, double extra_rounding = 0) {
    SmoothingPath path = GetParam();
    path.position_tolerance += extra_rounding / e_;
    EXPECT_TRUE(same_smoothing(transformed(smoothed(changed, path.parameters), back), result_, path, e_));
  }

  const FlatMesh mesh_ = noisy_shape("torus", 1500);
  const double e_ = average_edge_length(mesh_);
  const FlatMesh result_ = smoothed(mesh_, GetParam().parameters);
};

// A scan in the coordinates of a national grid. What is left of the coordinates there, 1e-10, is their own rounding.
TEST_P(Invariance, OfTranslationByAMillion) {
  for (const Point& shift : {Point(1e6, 0, 0), Point(-1e6, 1e6, 1e6), Point(1234567.0, -7654321.0, 0.5)}) {
    const auto there = [&](const Point& p) { return p + shift; };
    const auto back = [&](const Point& p) { return p - shift; };
    // Compared with the result for the mesh as it was rounded there.
    const FlatMesh rounded = transformed(transformed(mesh_, there), back);
    SmoothingPath path = GetParam();
    path.position_tolerance += 1e-8 / e_;
    EXPECT_TRUE(same_smoothing(transformed(smoothed(transformed(mesh_, there), path.parameters), back),
                               smoothed(rounded, path.parameters), path, e_));
  }
}

TEST_P(Invariance, OfRotation) {
  for (const auto& [axis, angle] : {std::pair(Point(1, 2, 3), 0.7), std::pair(Point(-1, 0.3, 0), 2.9)}) {
    vcg::Matrix44d there;
    there.SetRotateRad(angle, axis);
    vcg::Matrix44d back;
    back.SetRotateRad(-angle, axis);
    expect_same(transformed(mesh_, [&, m = there](const Point& p) { return m * p; }),
                [&, m = back](const Point& p) { return m * p; });
  }
}

TEST_P(Invariance, OfReflection) {
  const auto mirror = [](const Point& p) { return Point(-p[0], p[1], p[2]); };
  FlatMesh mirrored = transformed(mesh_, mirror);
  for (Triangle& f : mirrored.faces) std::swap(f[1], f[2]);
  expect_same(mirrored, mirror);
}

// Inside out, all normals turn, and so do all heights.
TEST_P(Invariance, OfOrientation) {
  FlatMesh turned = mesh_;
  for (Triangle& f : turned.faces) std::swap(f[0], f[1]);
  expect_same(turned, [](const Point& p) { return p; });
}

TEST_P(Invariance, OfScale) {
  for (const double scale : {1e-12, 1e-6, 1e6, 1e12, 1e-100, 1e100})
    expect_same(transformed(mesh_, [&](const Point& p) { return p * scale; }),
                [&](const Point& p) { return p / scale; });
}

// A power of two rounds nothing: the same bits.
TEST_P(Invariance, OfScaleByAPowerOfTwoBitForBit) {
  for (const int exponent : {-400, -40, -1, 1, 20, 300}) {
    const double scale = std::ldexp(1.0, exponent);
    const FlatMesh scaled = transformed(mesh_, [&](const Point& p) { return p * scale; });
    EXPECT_TRUE(same_bits(
        transformed(smoothed(scaled, GetParam().parameters), [&](const Point& p) { return p / scale; }), result_))
        << exponent;
  }
}

std::vector<std::size_t> shuffled(std::size_t count, mesh_tools::Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t k = count; k > 1; --k)
    std::swap(order[k - 1], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
  return order;
}

TEST_P(Invariance, OfTheOrderOfVertices) {
  mesh_tools::Random random(3);
  const std::vector<std::size_t> order = shuffled(mesh_.points.size(), random);
  FlatMesh mesh = mesh_;
  for (std::size_t v = 0; v < order.size(); ++v) mesh.points[order[v]] = mesh_.points[v];
  for (Triangle& f : mesh.faces)
    for (std::size_t& v : f) v = order[v];
  const FlatMesh result = smoothed(mesh, GetParam().parameters);
  FlatMesh back = result_;
  for (std::size_t v = 0; v < order.size(); ++v) back.points[v] = result.points[order[v]];
  EXPECT_TRUE(same_smoothing(back, result_, GetParam(), e_));
}

TEST_P(Invariance, OfTheOrderOfFacesAndOfTheirCorners) {
  mesh_tools::Random random(4);
  FlatMesh mesh = mesh_;
  const std::vector<std::size_t> order = shuffled(mesh.faces.size(), random);
  for (std::size_t f = 0; f < order.size(); ++f) {
    mesh.faces[order[f]] = mesh_.faces[f];
    std::rotate(mesh.faces[order[f]].begin(), mesh.faces[order[f]].begin() + f % 3, mesh.faces[order[f]].end());
  }
  EXPECT_TRUE(same_smoothing(smoothed(mesh, GetParam().parameters), result_, GetParam(), e_));
}

// Two parts of a mesh know nothing of each other, but for |e|, which is that of both.
TEST_P(Invariance, OfWhatElseIsInTheMesh) {
  FlatMesh both = mesh_;
  append(both, transformed(mesh_, [](const Point& p) { return p + Point(0.01, 0, 0); }));
  FlatMesh result = smoothed(both, GetParam().parameters);
  result.points.resize(mesh_.points.size());
  EXPECT_TRUE(same_smoothing(result, result_, GetParam(), e_));
}

INSTANTIATE_TEST_SUITE_P(Paths, Invariance, testing::ValuesIn(smoothing_paths()), name_of_path);

}  // namespace
