#include "point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace vcg_core::detail {

namespace {

constexpr int bits_per_axis = 21;
/// No distance is below 0 < 0: a radius that rounds to nothing still finds what lies at the very place.
constexpr double smallest = std::numeric_limits<double>::min();
constexpr std::int64_t last_cell = (std::int64_t(1) << bits_per_axis) - 1;

}  // namespace

PointGrid::PointGrid(const std::vector<Vec3>& position, const std::vector<Index>& points, double radius)
    : squared_radius_(std::max(radius * radius, smallest)),
      key_(points.size()),
      index_(points.size()),
      position_(points.size()) {
  Eigen::AlignedBox3d box;
  for (const Index i : points) box.extend(position[i]);
  origin_ = points.empty() ? Vec3(Vec3::Zero()) : Vec3(box.min());
  const double extent = points.empty() ? 0.0 : box.sizes().maxCoeff();
  // A little wider than the radius, against rounding; and never so small that the cells cannot be numbered.
  cell_size_ = std::max({radius * (1 + 1e-9), extent / static_cast<double>(last_cell - 2), smallest});

  std::vector<std::pair<std::uint64_t, Index>> order(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto cell = cell_of(position[points[k]]);
    order[k] = {key_of(cell[0], cell[1], cell[2]), points[k]};
  }
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < order.size(); ++k) {
    key_[k] = order[k].first;
    index_[k] = order[k].second;
    position_[k] = position[order[k].second];
  }
}

/// Cells count from 1, so that those around the first and the last one have numbers too; places farther outside than
/// that share the number of the cell at the rim, which is near no point that is not near them.
std::array<std::int64_t, 3> PointGrid::cell_of(const Vec3& p) const {
  std::array<std::int64_t, 3> cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double c = std::floor((p[axis] - origin_[axis]) / cell_size_) + 1;
    cell[axis] = static_cast<std::int64_t>(std::clamp(c, 0.0, static_cast<double>(last_cell)));
  }
  return cell;
}

std::uint64_t PointGrid::key_of(std::int64_t x, std::int64_t y, std::int64_t z) {
  return static_cast<std::uint64_t>((z << 2 * bits_per_axis) | (y << bits_per_axis) | x);
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
      if (z >= 0 && y >= 0 && z <= last_cell && y <= last_cell) {
        const std::int64_t first = std::max<std::int64_t>(cell[0] - 1, 0);
        const std::int64_t last = std::min(cell[0] + 1, last_cell);
        rows_[row] = {place(key_of(first, y, z)), place(key_of(last, y, z) + 1)};
      }
      ++row;
    }
}

}  // namespace vcg_core::detail
