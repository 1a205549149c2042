// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid.h"

namespace tiles {

/// Cells of a grid.
class CellSet {
 public:
  explicit CellSet(const Grid& grid) : grid_(grid), is_in_(grid.cells()) {}

  bool contains(std::uint32_t cell) const { return is_in_[cell]; }
  void add(std::uint32_t cell) { is_in_[cell] = true; }
  /// Adds all cells with a point within `distance` of a point of that cell.
  void add_around(std::uint32_t cell, double distance);
  /// The same for the cell of p.
  void add_around(const Point& p, double distance);

 private:
  void add_around(const std::array<std::uint32_t, 3>& place, double distance);

  const Grid& grid_;
  std::vector<bool> is_in_;
};

}  // namespace tiles
