// SPDX-License-Identifier: GPL-3.0-or-later
// The example of docs/library.md; and that it takes neither vcglib's headers nor Eigen's.

#include <cstdint>
#include <vector>

#include <vcg_core/mesh/guided_measures.h>
#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/smoothing.h>

#if defined(EIGEN_WORLD_VERSION) || defined(__VCG_MESH) || defined(__VCGLIB_POINT3)
#error "the headers of the mesh view include those of another library"
#endif

void denoise(std::vector<float>& xyz, const std::vector<std::uint32_t>& triangles, std::vector<double>& weights) {
  vcg_core::MeshView mesh = vcg_core::packed_mesh(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3);
  mesh.weights = vcg_core::real_rows(weights.data(), sizeof(double));  // 0: stays, 1: follows
  vcg_core::SmoothingLimits limits;
  limits.max_displacement = 0.01;  // in the mesh's unit
  const vcg_core::Method method = vcg_core::Method::guided;
  vcg_core::smooth(mesh, method, vcg_core::method_info(method).defaults, {}, limits);
}

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include <support/noisy_shapes.h>
#include <support/packed.h>

namespace {

TEST(PlainHeaders, AreEnoughForTheExample) {
  test_support::Packed<float> packed(test_support::noisy_shape("sphere", 2000, 0.3));
  const std::vector<float> before = packed.positions;
  std::vector<double> weights(packed.vertices(), 1);
  weights[5] = 0;
  denoise(packed.positions, packed.triangles, weights);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < packed.vertices(); ++v) {
    double square = 0;
    for (std::size_t k = 3 * v; k < 3 * v + 3; ++k) square += std::pow(packed.positions[k] - before[k], 2);
    moved += square > 0;
    EXPECT_LT(std::sqrt(square), 0.01 + 1e-6);
    if (v == 5) {
      EXPECT_EQ(square, 0);
    }
  }
  EXPECT_EQ(moved, packed.vertices() - 1);
}

}  // namespace
