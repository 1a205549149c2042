// SPDX-License-Identifier: GPL-3.0-or-later
#include "median_sample.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bucket_file.h"

namespace tiles {
namespace {

struct FilledCell {
  std::uint32_t number;
  std::uint64_t vertices_before;  ///< in the cells of lower numbers
};

/// How many vertices each cell of the grid has.
std::vector<std::uint32_t> vertices_in_cells(const Plan& plan) {
  std::vector<std::uint32_t> in_cell(plan.grid.cells());
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    const BucketFile bucket(plan.bucket_path(tile), plan.real_size);
    for (std::size_t i = 0; i < bucket.cells(); ++i) in_cell[bucket.cell(i)] += bucket.vertices_in(i);
  }
  return in_cell;
}

/// The i-th of numbers from 0 to 1 that fill the interval evenly, however many there are.
double evenly(std::size_t i) {
  constexpr double golden_ratio = 0.6180339887498949;
  const double x = (static_cast<double>(i) + 0.5) * golden_ratio;
  return x - std::floor(x);
}

}  // namespace

CellSet median_sample(const Plan& plan, double reach, std::size_t most_vertices) {
  CellSet chosen(plan.grid);
  const std::vector<std::uint32_t> in_cell = vertices_in_cells(plan);
  std::vector<FilledCell> filled;
  std::uint64_t vertices = 0;
  for (std::uint32_t cell = 0; cell < in_cell.size(); ++cell) {
    if (in_cell[cell] == 0) continue;
    filled.push_back({cell, vertices});
    vertices += in_cell[cell];
  }
  if (vertices <= most_vertices) {
    for (const FilledCell& cell : filled) chosen.add(cell.number);
    return chosen;
  }
  const auto for_each_near = [&](std::uint32_t cell, const auto& visit) {
    for_each_cell_around(plan.grid, plan.grid.place_of_cell(cell), reach, visit);
  };
  CellSet with_surroundings(plan.grid);
  std::uint64_t needed = 0;
  for (std::size_t i = 0; i < filled.size(); ++i) {
    const auto at = static_cast<std::uint64_t>(evenly(i) * static_cast<double>(vertices));
    const auto after =
        std::upper_bound(filled.begin(), filled.end(), at,
                         [](std::uint64_t place, const FilledCell& cell) { return place < cell.vertices_before; });
    const std::uint32_t seed = std::prev(after)->number;
    for_each_near(seed, [&](std::uint32_t own) {
      if (chosen.contains(own) || in_cell[own] == 0) return;
      for_each_near(own, [&](std::uint32_t cell) {
        if (!with_surroundings.contains(cell)) needed += in_cell[cell];
        with_surroundings.add(cell);
      });
    });
    if (i > 0 && needed > most_vertices) break;
    chosen.add_around(seed, reach);
  }
  return chosen;
}

}  // namespace tiles
