// SPDX-License-Identifier: GPL-3.0-or-later
// Copying a mesh to arrays loses nothing, and what the topology says is right.

#include <mesh/read_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <job.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>
#include <vcg_core/errors.h>
#include <vcg_core/mesh/vcglib_view.h>

#include <power_of_two.h>

namespace {

using namespace test_support;
using vcg_core::detail::Index;
using vcg_core::detail::Job;
using vcg_core::detail::MeshArrays;
using vcg_core::detail::PowerOfTwo;

MeshArrays read(const FlatMesh& shape) {
  DoubleMesh mesh;
  fill(mesh, shape);
  const vcg_core::Progress no_progress;
  Job job(no_progress, 2);
  return vcg_core::detail::read_mesh(vcg_core::view_of(mesh), job);
}

TEST(ReadMesh, PositionsComeBackBitForBitFromAnyScaleAndPlace) {
  for (const double scale : {1e-300, 1e-12, 1.0, 1e12, 1e300})
    for (const double shift : {0.0, 1e6}) {
      const FlatMesh shape =
          transformed(potato(1), [&](const Point& p) { return (p + Point(shift, 0, shift)) * scale; });
      const MeshArrays arrays = read(shape);
      const PowerOfTwo to_host(-arrays.exponent);
      for (std::size_t i = 0; i < arrays.size(); ++i) {
        const auto back = (to_host * arrays.position[i]).eval();
        const Point& given = shape.points[arrays.host_vertex[i]];
        for (int k = 0; k < 3; ++k) EXPECT_EQ(back[k], given[k]);
        const double largest = arrays.position[i].cwiseAbs().maxCoeff();
        EXPECT_LT(largest, 1e20);  // its fourth power is a number still
      }
    }
}

TEST(ReadMesh, AverageEdgeLengthBorderAndStarsAreThoseOfTheMesh) {
  for (const char* const name : {"plane_delaunay", "torus", "thin_sheets"}) {
    const FlatMesh shape = noisy_shape(name, 500);
    const MeshArrays arrays = read(shape);
    const NaiveReference reference(shape);
    const double e = std::ldexp(arrays.topology.average_edge_length, -arrays.exponent);
    EXPECT_NEAR(e, reference.average_edge_length(), 1e-14 * e) << name;
    std::vector<std::size_t> faces_at(shape.points.size(), 0);
    for (const Triangle& f : shape.faces)
      for (const std::size_t v : f) ++faces_at[v];
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      const std::size_t host = arrays.host_vertex[i];
      EXPECT_EQ(arrays.topology.border[i] != 0, reference.on_border(host));
      EXPECT_EQ(arrays.topology.star_begin[i + 1] - arrays.topology.star_begin[i], faces_at[host]);
      for (Index s = arrays.topology.star_begin[i]; s < arrays.topology.star_begin[i + 1]; ++s)
        EXPECT_EQ(vertex_of(arrays, arrays.topology.star[s]), i);
    }
  }
}

// Vertices of few faces and of many, edges of one, two and more, against counting them one by one.
TEST(ReadMesh, EdgesOfASoupOfFacesAreCountedOnceEach) {
  constexpr std::uint32_t count = 40;
  for (const std::size_t faces : {20, 60, 150, 400}) {
    std::mt19937 random(static_cast<unsigned>(faces));
    FlatMesh soup;
    for (std::uint32_t v = 0; v < count; ++v) soup.points.emplace_back(std::cos(v), std::sin(v), 0.1 * v);
    while (soup.faces.size() < faces) {
      const std::uint32_t a = random() % count;
      const std::uint32_t b = random() % (random() % count + 1);  // some vertices get more than others
      const std::uint32_t c = random() % count;
      if (a != b && b != c && c != a) soup.faces.push_back({a, b, c});
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces_at_edge;
    for (const Triangle& f : soup.faces)
      for (int k = 0; k < 3; ++k) ++faces_at_edge[std::minmax(f[k], f[(k + 1) % 3])];
    double length = 0;
    std::set<std::uint32_t> on_border;
    std::set<std::uint32_t> non_manifold;
    for (const auto& [edge, n] : faces_at_edge) {
      length += (soup.points[edge.first] - soup.points[edge.second]).Norm();
      if (n == 1) on_border.insert({edge.first, edge.second});
      if (n > 2) non_manifold.insert({edge.first, edge.second});
    }
    const MeshArrays arrays = read(soup);
    const double e = length / static_cast<double>(faces_at_edge.size());
    EXPECT_NEAR(std::ldexp(arrays.topology.average_edge_length, -arrays.exponent), e, 1e-14 * e);
    EXPECT_EQ(arrays.topology.border_vertices, on_border.size());
    EXPECT_EQ(arrays.topology.non_manifold_vertices, non_manifold.size());
    for (std::size_t i = 0; i < arrays.size(); ++i)
      EXPECT_EQ(arrays.topology.border[i] != 0, on_border.count(arrays.host_vertex[i]) == 1);
  }
}

/// What a mesh of this size is refused with; one that is not refused would be read beyond its end.
std::string refusal(std::size_t vertices, std::size_t faces) {
  const vcg_core::Progress no_progress;
  Job job(no_progress, 1);
  double position[3] = {};
  const std::uint32_t triangle[3] = {};
  try {
    vcg_core::detail::read_mesh(vcg_core::packed_mesh(position, vertices, triangle, faces), job);
  } catch (const vcg_core::InvalidMesh& error) {
    return error.what();
  }
  return "nothing thrown";
}

// 3 * face + 2 has to be less than 2^32 - 1, which stands for no corner: 1,431,655,765 faces give 4,294,967,294.
TEST(ReadMesh, TooManyVerticesOrFacesAreRefused) {
  const std::size_t most = 1431655765;
  EXPECT_EQ(3 * (most - 1) + 2, 4294967294u);
  EXPECT_NE(refusal(3, most + 1).find("has 1431655766 faces; at most 1431655765"), std::string::npos);
  EXPECT_NE(refusal(most + 1, 1).find("has 1431655766 vertices; at most 1431655765"), std::string::npos);
  EXPECT_NE(refusal(3, std::size_t(1) << 32).find("has 4294967296 faces"), std::string::npos);
  EXPECT_NO_THROW(vcg_core::detail::require_countable(most, most));
}

TEST(ReadMesh, PowersOfTwoBeyondTheRangeOfDoubleAreTakenInTwoSteps) {
  EXPECT_EQ(PowerOfTwo(1074) * std::ldexp(1.0, -1074), 1);
  EXPECT_EQ(PowerOfTwo(-1074) * 1.0, std::ldexp(1.0, -1074));
  EXPECT_EQ(PowerOfTwo(-1023) * std::ldexp(1.5, 1023), 1.5);
  EXPECT_EQ(PowerOfTwo(0) * 0.1, 0.1);
}

}  // namespace
