// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "job.h"
#include "radix_sort.h"

namespace vcg_core::detail {

namespace {

/// Three numbers make a key of 64 bits.
constexpr int most_bits_per_axis = 21;
constexpr std::int64_t most_numbers = std::int64_t(1) << most_bits_per_axis;
/// Beyond that many cells along an axis double precision does not tell them apart any more.
constexpr double most_cells = 4398046511104.0;  // 2^42
/// A squared radius that rounds to 0 would find nothing, not even the points at the very place.
constexpr double smallest = std::numeric_limits<double>::min();

}  // namespace

PointGrid::PointGrid(const Array<Vec3>& position, const Array<Index>& points, double radius, Job* job)
    : squared_radius_(std::max(radius * radius, smallest)),
      key_(points.size()),
      index_(points),
      position_(points.size()) {
  const auto for_each = [job](std::size_t count, const auto& body) {
    if (job != nullptr) return job->serial(count, body);
    for (std::size_t k = 0; k < count; ++k) body(k);
  };
  Eigen::AlignedBox3d box;
  for_each(points.size(), [&](std::size_t k) { box.extend(position[points[k]]); });
  origin_ = points.empty() ? Vec3(Vec3::Zero()) : Vec3(box.min());
  const double extent = points.empty() ? 0.0 : box.sizes().maxCoeff();
  // A little wider than the radius, against rounding, which grows with the number of cells.
  cell_size_ = std::max(radius * (1 + 1e-9), smallest);
  const bool many_cells = extent / cell_size_ > static_cast<double>(most_numbers - 4);
  if (many_cells) cell_size_ = std::max({radius * 1.01, extent / most_cells, smallest});
  last_cell_ = std::llround(std::floor(extent / cell_size_)) + 2;
  last_number_ = last_cell_;
  if (many_cells) {
    last_number_ = 0;
    for (int axis = 0; axis < 3; ++axis) number_layers(axis, position);
  }
  bits_per_axis_ = 1;
  while (std::int64_t(1) << bits_per_axis_ <= last_number_) ++bits_per_axis_;

  for_each(points.size(), [&](std::size_t k) {
    const auto cell = cell_of(position[points[k]]);
    key_[k] = key_of(number_of(0, cell[0]), number_of(1, cell[1]), number_of(2, cell[2]));
  });
  radix_sort(key_, index_, 3 * bits_per_axis_, job);
  for_each(index_.size(), [&](std::size_t k) { position_[k] = position[index_[k]]; });
}

/// Numbers count from 1, as cells do. More layers than there are numbers (over a million, none next to another) share
/// the last one: then more points are looked at.
void PointGrid::number_layers(int axis, const Array<Vec3>& position) {
  Array<std::int64_t>& cells = layers_[axis].cell;
  for (const Index i : index_) cells.push_back(cell_of(position[i])[axis]);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::int64_t number = 1;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k > 0) number += cells[k] - cells[k - 1] == 1 ? 1 : 2;
    layers_[axis].number.push_back(std::min(number, most_numbers - 3));
  }
  if (!cells.empty()) last_number_ = std::max(last_number_, layers_[axis].number.back() + 1);
}

/// Of an empty layer the number next to that of a neighbour; -1 where both neighbours are empty as well.
std::int64_t PointGrid::number_of(int axis, std::int64_t cell) const {
  const Layers& layers = layers_[axis];
  if (layers.cell.empty()) return cell;
  const auto place =
      static_cast<std::size_t>(std::lower_bound(layers.cell.begin(), layers.cell.end(), cell) - layers.cell.begin());
  if (place < layers.cell.size() && layers.cell[place] == cell) return layers.number[place];
  if (place > 0 && layers.cell[place - 1] == cell - 1) return layers.number[place - 1] + 1;
  if (place < layers.cell.size() && layers.cell[place] == cell + 1) return layers.number[place] - 1;
  return -1;
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
  const std::int64_t x = grid_.number_of(0, cell[0]);
  const std::int64_t y = grid_.number_of(1, cell[1]);
  const std::int64_t z = grid_.number_of(2, cell[2]);
  const bool nowhere = x < 0 || y < 0 || z < 0;
  const auto place = [&](std::uint64_t key) {
    return static_cast<std::size_t>(std::lower_bound(grid_.key_.begin(), grid_.key_.end(), key) - grid_.key_.begin());
  };
  std::size_t row = 0;
  for (std::int64_t k = z - 1; k <= z + 1; ++k)
    for (std::int64_t j = y - 1; j <= y + 1; ++j) {
      rows_[row] = {0, 0};
      if (!nowhere && k >= 0 && j >= 0 && k <= grid_.last_number_ && j <= grid_.last_number_) {
        const std::int64_t first = std::max<std::int64_t>(x - 1, 0);
        const std::int64_t last = std::min(x + 1, grid_.last_number_);
        rows_[row] = {place(grid_.key_of(first, j, k)), place(grid_.key_of(last, j, k) + 1)};
      }
      ++row;
    }
}

}  // namespace vcg_core::detail
