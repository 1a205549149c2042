// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <system_error>

#include <tiles/tiles.h>

#include "disk_space.h"
#include "fail.h"
#include "large_mesh.h"

namespace tiles {
namespace {

/// Of a process without any mesh, and of the grid.
constexpr std::uint64_t base_memory = std::uint64_t(60) << 20;

/// The smallest tile that is made for a limit of memory.
constexpr std::size_t fewest_vertices = 20000;

/// What a method needs.
struct Needs {
  std::uint64_t of_vertex;  ///< bytes for each vertex of a piece, positions in and out and faces included, in double
                            ///< precision
  double edges_around;      ///< from one side of a tile to the other its surroundings add this, in edges, and
  double cells_around;      ///< this, in cells; tiles with several sheets included
  std::uint64_t of_whole;   ///< bytes for each vertex of a file that is smoothed at once
};

Needs needs_of(vcg_core::Method method) {
  if (method == vcg_core::Method::guided) return {650, 120, 8, 620};  // even meshes take 430
  return {720, 40, 0, 620};                                           // of the reach about 12, the rest are cells
}

/// Vertices of a tile's piece, where tiles are not tiny.
double with_surroundings(std::size_t tile_vertices, std::size_t vertices, vcg_core::Method method) {
  constexpr double most_cells = 3 * 256.0 * 256.0;  // that a surface fills
  const double in_cell = std::max(vertices_in_cell(tile_vertices, method), static_cast<double>(vertices) / most_cells);
  const Needs needs = needs_of(method);
  const double across =
      std::sqrt(static_cast<double>(tile_vertices)) + needs.edges_around + needs.cells_around * std::sqrt(in_cell);
  return across * across;
}

}  // namespace

double vertices_in_cell(std::size_t tile_vertices, vcg_core::Method method) {
  const double cells = method == vcg_core::Method::guided ? 16384 : 4096;
  return std::max(8.0, static_cast<double>(tile_vertices) / cells);
}

std::uint64_t memory_of_piece(std::size_t tile_vertices, std::size_t vertices, std::size_t faces,
                              vcg_core::Method method) {
  const std::uint64_t bits = (vertices + faces) / 8 * 3 / 2;  // of IndexSet
  return base_memory + bits +
         static_cast<std::uint64_t>(with_surroundings(tile_vertices, vertices, method)) * needs_of(method).of_vertex;
}

std::uint64_t memory_of_plan(std::size_t vertices) {
  constexpr std::uint64_t buffers = std::uint64_t(32) << 20, bytes_of_cell = 6;
  const double along =
      std::min(256.0, std::sqrt(static_cast<double>(vertices) / 24));  // cells, as make_plan() has them
  return base_memory + buffers + static_cast<std::uint64_t>(along * along * along) * bytes_of_cell +
         vertices * sizeof(std::uint16_t);
}

std::uint64_t disk_bytes(std::size_t vertices, std::size_t faces, std::size_t real_size, std::size_t normal_size) {
  constexpr double face_copies = 1.25;  // faces over the rims of cells are there several times
  const std::size_t bucket_face = 16, index = 4;
  return vertices * (index + 2 * 3 * real_size + 3 * normal_size) +
         static_cast<std::uint64_t>(face_copies * static_cast<double>(faces * bucket_face));
}

std::size_t tile_vertices_within(std::uint64_t memory, const std::filesystem::path& input, vcg_core::Method method) {
  const LargeMesh mesh(input);
  const std::uint64_t least = std::max(memory_of_plan(mesh.vertices()),
                                       memory_of_piece(fewest_vertices, mesh.vertices(), mesh.faces(), method));
  if (memory < least)
    fail(input, "with " + std::to_string(mesh.vertices()) + " vertices needs at least " + in_bytes(least) +
                    " of memory; allowed are " + in_bytes(memory));
  std::size_t low = fewest_vertices, high = std::max(fewest_vertices + 1, mesh.vertices());
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (memory_of_piece(middle, mesh.vertices(), mesh.faces(), method) <= memory ? low : high) = middle;
  }
  return low;
}

std::uint64_t memory_of_whole(const std::filesystem::path& input, vcg_core::Method method) {
  const std::uint64_t of_vertex = needs_of(method).of_whole;
  constexpr std::uint64_t bytes_of_file_per_vertex = 38;  // at least, of text too
  std::uint64_t bytes = 0;
  try {
    const LargeMesh mesh(input);
    bytes = (mesh.is_stl() ? mesh.vertices() / 6 : mesh.vertices()) * of_vertex;
  } catch (const std::runtime_error&) {  // no file that can be cut: whoever reads it says what it lacks
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(input, error);
    if (!error) bytes = size * of_vertex / bytes_of_file_per_vertex;
  }
  return base_memory + bytes;
}

}  // namespace tiles
