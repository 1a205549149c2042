// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tiles {
namespace {

constexpr std::uint32_t no_axis = 3;

}  // namespace

Cut::Cut(const Grid& grid, const std::vector<std::uint32_t>& in_cell, std::size_t tiles) : grid_(grid) {
  split(all(), in_cell, std::clamp<std::size_t>(tiles, 1, most_tiles));
  tile_of_cell_.resize(grid.cells());
  fill(0, all());
}

Cut::Cut(const Grid& grid, std::vector<Node> nodes) : grid_(grid), nodes_(std::move(nodes)) {
  for (const Node& node : nodes_) tiles_ += node.axis == no_axis;
  tile_of_cell_.resize(grid.cells());
  fill(0, all());
}

Cut::Range Cut::all() const { return {{0, 0, 0}, {grid_.size()[0], grid_.size()[1], grid_.size()[2]}}; }

/// Along the longest side of what holds vertices, so that their numbers go as the numbers of tiles on both sides.
std::uint32_t Cut::split(const Range& range, const std::vector<std::uint32_t>& in_cell, std::size_t tiles) {
  std::array<std::vector<std::uint64_t>, 3> slices;
  for (std::size_t k = 0; k < 3; ++k) slices[k].assign(range.end[k] - range.begin[k], 0);
  for (std::uint32_t z = range.begin[2]; z < range.end[2]; ++z)
    for (std::uint32_t y = range.begin[1]; y < range.end[1]; ++y)
      for (std::uint32_t x = range.begin[0]; x < range.end[0]; ++x) {
        const std::uint32_t count = in_cell[grid_.cell_at({x, y, z})];
        slices[0][x - range.begin[0]] += count;
        slices[1][y - range.begin[1]] += count;
        slices[2][z - range.begin[2]] += count;
      }
  std::uint32_t axis = no_axis, first = 0, last = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto is_used = [](std::uint64_t count) { return count > 0; };
    const auto begin = std::find_if(slices[k].begin(), slices[k].end(), is_used);
    const auto end = std::find_if(slices[k].rbegin(), slices[k].rend(), is_used).base();
    if (begin >= end || end - begin <= (axis == no_axis ? 1 : static_cast<std::ptrdiff_t>(last - first))) continue;
    axis = k;
    first = static_cast<std::uint32_t>(begin - slices[k].begin());
    last = static_cast<std::uint32_t>(end - slices[k].begin());
  }
  const auto here = static_cast<std::uint32_t>(nodes_.size());
  if (tiles < 2 || axis == no_axis) {
    nodes_.push_back({no_axis, 0, static_cast<std::uint32_t>(tiles_++), 0});
    return here;
  }
  std::uint64_t total = 0;
  for (const std::uint64_t count : slices[axis]) total += count;
  const std::size_t low_tiles = tiles / 2;
  const double wanted = static_cast<double>(total) * static_cast<double>(low_tiles) / static_cast<double>(tiles);
  std::uint32_t at = first + 1;
  double below = static_cast<double>(slices[axis][first]);
  while (at + 1 < last && below + static_cast<double>(slices[axis][at]) / 2 < wanted)
    below += static_cast<double>(slices[axis][at++]);
  nodes_.push_back({axis, range.begin[axis] + at, 0, 0});
  Range low = range, high = range;
  low.end[axis] = high.begin[axis] = range.begin[axis] + at;
  const std::uint32_t low_node = split(low, in_cell, low_tiles);
  const std::uint32_t high_node = split(high, in_cell, tiles - low_tiles);
  nodes_[here].low = low_node;
  nodes_[here].high = high_node;
  return here;
}

void Cut::fill(std::uint32_t node, const Range& range) {
  const Node& cut = nodes_[node];
  if (cut.axis == no_axis) {
    for (std::uint32_t z = range.begin[2]; z < range.end[2]; ++z)
      for (std::uint32_t y = range.begin[1]; y < range.end[1]; ++y)
        for (std::uint32_t x = range.begin[0]; x < range.end[0]; ++x)
          tile_of_cell_[grid_.cell_at({x, y, z})] = static_cast<std::uint16_t>(cut.low);
    return;
  }
  Range low = range, high = range;
  low.end[cut.axis] = high.begin[cut.axis] = cut.at;
  fill(cut.low, low);
  fill(cut.high, high);
}

}  // namespace tiles
