// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_order.h"

#include <algorithm>
#include <tuple>

#include <Eigen/Geometry>

#include "job.h"
#include "radix_sort.h"
#include "volume.h"

namespace vcg_core::detail {

namespace {

constexpr int bits_per_axis = 21;

/// Spreads the low 21 bits of x to every third bit.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffULL;
  x = (x | x << 16) & 0x001f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}

Array<std::uint64_t> morton_codes(const Array<Vec3>& position, const Eigen::AlignedBox3d& box, Job& job) {
  const double extent = position.empty() ? 0.0 : box.sizes().maxCoeff();
  const double cells = (1 << bits_per_axis) - 1;
  const double scale = extent > 0 ? cells / extent : 0.0;
  Array<std::uint64_t> codes(position.size());
  job.serial(position.size(), [&](std::size_t i) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::clamp((position[i][axis] - box.min()[axis]) * scale, 0.0, cells);
      code |= spread(static_cast<std::uint64_t>(cell)) << axis;
    }
    codes[i] = code;
  });
  return codes;
}

/// Sorts each run of equal codes by coordinates and index.
void sort_within_codes(const Array<Vec3>& position, SpatialOrder& spatial, Job& job) {
  std::size_t steps = 0;
  const auto poll = [&] {
    if (++steps % 65536 == 0) job.poll();
  };
  const auto less = [&](Index a, Index b) {
    poll();  // all points may lie in one cell
    const Vec3& p = position[a];
    const Vec3& q = position[b];
    return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
  };
  for (std::size_t begin = 0, end = 0; begin < spatial.code.size(); begin = end) {
    poll();
    while (end < spatial.code.size() && spatial.code[end] == spatial.code[begin]) ++end;
    if (end - begin < 2) continue;
    const auto first = spatial.order.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, first + static_cast<std::ptrdiff_t>(end - begin), less);
  }
}

}  // namespace

SpatialOrder morton_order(const Array<Vec3>& position, Job& job) {
  return morton_order(position, bounding_box(position, job), job);
}

SpatialOrder morton_order(const Array<Vec3>& position, const Eigen::AlignedBox3d& box, Job& job) {
  SpatialOrder result{Array<Index>(position.size()), morton_codes(position, box, job)};
  job.serial(position.size(), [&](std::size_t i) { result.order[i] = static_cast<Index>(i); });
  radix_sort(result.code, result.order, 3 * bits_per_axis, &job);
  sort_within_codes(position, result, job);
  return result;
}

}  // namespace vcg_core::detail
