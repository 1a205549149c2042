// SPDX-License-Identifier: GPL-3.0-or-later
// Windows' own headers define short words as macros. The public headers do not mind: here they come after such macros,
// and all that they include before.

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <vcg/complex/complex.h>
#include <Eigen/Core>

#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define interface struct
#define IN
#define OUT
#define OPTIONAL
#define ERROR 0
#define DELETE (0x00010000L)

#include <vcg_core/distance_colors.h>
#include <vcg_core/errors.h>
#include <vcg_core/geodesic_distance.h>
#include <vcg_core/mesh/guided_measures.h>
#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/smoothing.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vcg_core/self_intersections.h>
#include <vcg_core/smoothing.h>

namespace {

TEST(WindowsMacros, LeaveThePublicHeadersUsable) {
  float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  vcg_core::MeshView mesh = vcg_core::packed_mesh(positions, 4, triangles, 4);
  const vcg_core::Method method = vcg_core::Method::paper;
  const vcg_core::SmoothingReport report = vcg_core::smooth(mesh, method, vcg_core::method_info(method).defaults);
  EXPECT_EQ(report.vertices, 4u);
  EXPECT_NEAR(report.volume_before, 1.0 / 6, 1e-6);
}

}  // namespace
