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

/// Of each vertex of a piece, its positions in and out and its faces included, in double precision.
constexpr std::uint64_t bytes_per_vertex = 720;

/// Vertices of a tile's piece for each of its own, where tiles are not tiny.
double with_surroundings(std::size_t tile_vertices) {
  constexpr double edges_around = 40;  // of the paper's filter about 6, and a cell
  const double across = std::sqrt(static_cast<double>(tile_vertices));
  return (across + edges_around) * (across + edges_around);
}

}  // namespace

std::uint64_t memory_of_piece(std::size_t tile_vertices, std::size_t vertices, std::size_t faces,
                              vcg_core::Method /*method*/) {
  const std::uint64_t bits = (vertices + faces) / 8 * 3 / 2;  // of IndexSet
  return base_memory + bits + static_cast<std::uint64_t>(with_surroundings(tile_vertices)) * bytes_per_vertex;
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
  constexpr std::size_t fewest = 20000;
  const LargeMesh mesh(input);
  const std::uint64_t least =
      std::max(memory_of_plan(mesh.vertices()), memory_of_piece(fewest, mesh.vertices(), mesh.faces(), method));
  if (memory < least)
    fail(input, "with " + std::to_string(mesh.vertices()) + " vertices needs at least " + in_bytes(least) +
                    " of memory; allowed are " + in_bytes(memory));
  std::size_t low = fewest, high = std::max(fewest + 1, mesh.vertices());
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (memory_of_piece(middle, mesh.vertices(), mesh.faces(), method) <= memory ? low : high) = middle;
  }
  return low;
}

std::uint64_t memory_of_whole(const std::filesystem::path& input, vcg_core::Method /*method*/) {
  constexpr std::uint64_t bytes_per_vertex_of_file = 620, bytes_per_byte_of_file = 16;
  std::uint64_t bytes = 0;
  try {
    const LargeMesh mesh(input);
    bytes = (mesh.is_stl() ? mesh.vertices() / 6 : mesh.vertices()) * bytes_per_vertex_of_file;
  } catch (const std::runtime_error&) {  // no file that can be cut: whoever reads it says what it lacks
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(input, error);
    if (!error) bytes = size * bytes_per_byte_of_file;
  }
  return base_memory + bytes;
}

}  // namespace tiles
