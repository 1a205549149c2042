// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_set.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tiles {
namespace {

/// Between the intervals of length 1 that begin at a and b.
double gap(std::uint32_t a, std::uint32_t b) {
  return std::max(0.0, std::abs(static_cast<double>(a) - static_cast<double>(b)) - 1);
}

double square(double x) { return x * x; }

}  // namespace

void for_each_cell_around(const Grid& grid, const std::array<std::uint32_t, 3>& place, double distance,
                          const std::function<void(std::uint32_t)>& visit) {
  const double limit = distance / grid.side();
  const double steps = std::min(std::ceil(limit) + 1, 1e6);
  std::array<std::uint32_t, 3> begin{}, end{};
  for (std::size_t k = 0; k < 3; ++k) {
    begin[k] = static_cast<std::uint32_t>(std::max(0.0, static_cast<double>(place[k]) - steps));
    end[k] = static_cast<std::uint32_t>(std::min<double>(grid.size()[k], static_cast<double>(place[k]) + steps + 1));
  }
  for (std::uint32_t z = begin[2]; z < end[2]; ++z)
    for (std::uint32_t y = begin[1]; y < end[1]; ++y)
      for (std::uint32_t x = begin[0]; x < end[0]; ++x)
        if (square(gap(x, place[0])) + square(gap(y, place[1])) + square(gap(z, place[2])) <= square(limit))
          visit(grid.cell_at({x, y, z}));
}

void CellSet::add_around(std::uint32_t cell, double distance) {
  for_each_cell_around(*grid_, grid_->place_of_cell(cell), distance, [&](std::uint32_t other) { add(other); });
}

void CellSet::add_around(const Point& p, double distance) {
  for_each_cell_around(*grid_, grid_->place_of(p), distance, [&](std::uint32_t other) { add(other); });
}

}  // namespace tiles
