// SPDX-License-Identifier: GPL-3.0-or-later
// What another thread costs in memory: its neighbourhoods, whatever the size of the mesh.

#include <algorithm>

#include <gtest/gtest.h>

#include <support/allocation_peak.h>
#include <support/mesh_types.h>
#include <support/noisy_shapes.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::Method;

class ThreadMemory : public testing::TestWithParam<Method> {};

TEST_P(ThreadMemory, DoesNotGrowWithTheMesh) {
  const FlatMesh noisy = noisy_shape("torus", 200000);
  const auto peak_with = [&](int threads) {
    DoubleMesh mesh;
    fill(mesh, noisy);
    vcg_core::SmoothingParameters parameters = vcg_core::method_info(GetParam()).defaults;
    parameters.threads = threads;
    const AllocationPeak peak;
    vcg_core::smooth(mesh, GetParam(), parameters);
    return peak.bytes();
  };
  const std::size_t one = peak_with(1), nine = peak_with(9);
  // Four bytes a vertex or face in each thread would be 6.4 or 12.8 MB.
  EXPECT_LT(std::max(nine, one) - one, 8 * std::size_t(1000000));
}

INSTANTIATE_TEST_SUITE_P(Methods, ThreadMemory, testing::Values(Method::paper, Method::guided),
                         [](const auto& instance) { return vcg_core::method_name(instance.param); });

}  // namespace
