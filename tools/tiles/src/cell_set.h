// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "grid.h"

namespace tiles {

/// Calls visit(cell) for all cells with a point within `distance` of a point of the cell at that place.
void for_each_cell_around(const Grid& grid, const std::array<std::uint32_t, 3>& place, double distance,
                          const std::function<void(std::uint32_t)>& visit);

/// Cells of a grid.
class CellSet {
 public:
  explicit CellSet(const Grid& grid) : grid_(&grid), is_in_(grid.cells()) {}

  bool contains(std::uint32_t cell) const { return is_in_[cell]; }
  void add(std::uint32_t cell) { is_in_[cell] = true; }
  void remove(const CellSet& others) {
    for (std::size_t cell = 0; cell < is_in_.size(); ++cell)
      if (others.is_in_[cell]) is_in_[cell] = false;
  }
  /// Adds all cells with a point within `distance` of a point of that cell.
  void add_around(std::uint32_t cell, double distance);
  /// The same for the cell of p.
  void add_around(const Point& p, double distance);

 private:
  const Grid* grid_;
  std::vector<bool> is_in_;
};

}  // namespace tiles
