// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid.h"

namespace tiles {

/// A cut of a grid into boxes of cells, the tiles: a plane halves the grid, others each half, and so on.
class Cut {
 public:
  /// Where a box is cut: the cells below `at` along `axis` go to `low`, the others to `high`. Of a tile, which is not
  /// cut, axis is 3, and `low` is its number.
  struct Node {
    std::uint32_t axis, at, low, high;
  };

  /// @param in_cell  how many vertices lie in each cell
  /// @param tiles    how many are wanted; where cells cannot be halved there are fewer
  Cut(const Grid& grid, const std::vector<std::uint32_t>& in_cell, std::size_t tiles);
  Cut(const Grid& grid, std::vector<Node> nodes);

  const std::vector<Node>& nodes() const { return nodes_; }
  std::size_t tiles() const { return tiles_; }
  std::size_t tile_of(std::uint32_t cell) const { return tile_of_cell_[cell]; }

 private:
  struct Range {
    std::uint32_t begin[3], end[3];
  };
  std::uint32_t split(const Range& range, const std::vector<std::uint32_t>& in_cell, std::size_t tiles);
  void fill(std::uint32_t node, const Range& range);
  Range all() const;

  Grid grid_;
  std::vector<Node> nodes_;
  std::vector<std::uint16_t> tile_of_cell_;
  std::size_t tiles_ = 0;
};

/// Most tiles that a cut can have.
constexpr std::size_t most_tiles = 60000;

}  // namespace tiles
