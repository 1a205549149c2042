// Copying a vcglib mesh to arrays loses nothing, and what the topology says is right.

#include <vcg_core/detail/read_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>

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
  return vcg_core::detail::read_mesh(mesh, job);
}

TEST(ReadMesh, PositionsComeBackBitForBitFromAnyScaleAndPlace) {
  for (const double scale : {1e-300, 1e-12, 1.0, 1e12, 1e300})
    for (const double shift : {0.0, 1e6}) {
      const FlatMesh shape =
          transformed(potato(1), [&](const Point& p) { return (p + Point(shift, 0, shift)) * scale; });
      const MeshArrays arrays = read(shape);
      const PowerOfTwo to_host(-arrays.exponent);
      double largest = 0;
      for (std::size_t i = 0; i < arrays.size(); ++i) {
        const auto back = (to_host * arrays.position[i]).eval();
        const Point& given = shape.points[arrays.host_vertex[i]];
        for (int k = 0; k < 3; ++k) EXPECT_EQ(back[k], given[k]);
        largest = std::max(largest, arrays.position[i].cwiseAbs().maxCoeff());
      }
      EXPECT_GE(largest, 1);
      EXPECT_LT(largest, 2);
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

TEST(ReadMesh, PowersOfTwoBeyondTheRangeOfDoubleAreTakenInTwoSteps) {
  EXPECT_EQ(PowerOfTwo(1074) * std::ldexp(1.0, -1074), 1);
  EXPECT_EQ(PowerOfTwo(-1074) * 1.0, std::ldexp(1.0, -1074));
  EXPECT_EQ(PowerOfTwo(-1023) * std::ldexp(1.5, 1023), 1.5);
  EXPECT_EQ(PowerOfTwo(0) * 0.1, 0.1);
}

}  // namespace
