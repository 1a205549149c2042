#include "point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <vcg_core/detail/job.h>

#include "radix_sort.h"

namespace vcg_core::detail {

namespace {

constexpr int most_bits_per_axis = 21;
/// No distance is below 0 < 0: a radius that rounds to nothing still finds what lies at the very place.
constexpr double smallest = std::numeric_limits<double>::min();
constexpr std::int64_t most_cells = std::int64_t(1) << most_bits_per_axis;

}  // namespace

PointGrid::PointGrid(const Array<Vec3>& position, const Array<Index>& points, double radius, Job* job)
    : squared_radius_(std::max(radius * radius, smallest)),
      key_(points.size()),
      index_(points),
      position_(points.size()) {
  const auto poll = [job] {
    if (job != nullptr) job->poll();
  };
  Eigen::AlignedBox3d box;
  poll();
  for (const Index i : points) box.extend(position[i]);
  poll();
  origin_ = points.empty() ? Vec3(Vec3::Zero()) : Vec3(box.min());
  const double extent = points.empty() ? 0.0 : box.sizes().maxCoeff();
  // A little wider than the radius, against rounding; and never so small that the cells cannot be numbered.
  cell_size_ = std::max({radius * (1 + 1e-9), extent / static_cast<double>(most_cells - 4), smallest});
  last_cell_ = std::llround(std::floor(extent / cell_size_)) + 2;
  bits_per_axis_ = 1;
  while (std::int64_t(1) << bits_per_axis_ <= last_cell_) ++bits_per_axis_;

  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto cell = cell_of(position[points[k]]);
    key_[k] = key_of(cell[0], cell[1], cell[2]);
  }
  poll();
  radix_sort(key_, index_, 3 * bits_per_axis_, job);
  for (std::size_t k = 0; k < index_.size(); ++k) position_[k] = position[index_[k]];
}

/// Cells count from 1, so that those around the first and the last one have numbers too; places farther outside than
/// that share the number of the cell at the rim, which is near no point that is not near them.
std::array<std::int64_t, 3> PointGrid::cell_of(const Vec3& p) const {
  std::array<std::int64_t, 3> cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double c = std::floor((p[axis] - origin_[axis]) / cell_size_) + 1;
    cell[axis] = static_cast<std::int64_t>(std::clamp(c, 0.0, static_cast<double>(last_cell_)));
  }
  return cell;
}

std::uint64_t PointGrid::key_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
  return static_cast<std::uint64_t>((z << 2 * bits_per_axis_) | (y << bits_per_axis_) | x);
}

void PointGrid::Search::find_rows(const std::array<std::int64_t, 3>& cell) {
  if (cell == cell_) return;
  cell_ = cell;
  const auto place = [&](std::uint64_t key) {
    return static_cast<std::size_t>(std::lower_bound(grid_.key_.begin(), grid_.key_.end(), key) - grid_.key_.begin());
  };
  std::size_t row = 0;
  for (std::int64_t z = cell[2] - 1; z <= cell[2] + 1; ++z)
    for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y) {
      rows_[row] = {0, 0};
      if (z >= 0 && y >= 0 && z <= grid_.last_cell_ && y <= grid_.last_cell_) {
        const std::int64_t first = std::max<std::int64_t>(cell[0] - 1, 0);
        const std::int64_t last = std::min(cell[0] + 1, grid_.last_cell_);
        rows_[row] = {place(grid_.key_of(first, y, z)), place(grid_.key_of(last, y, z) + 1)};
      }
      ++row;
    }
}

}  // namespace vcg_core::detail
