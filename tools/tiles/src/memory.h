// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include <vcg_core/method.h>

namespace tiles {

/// Vertices that a cell is meant to have, so that a tile has thousands of them: more where surroundings are wide, as
/// they are whole cells.
double vertices_in_cell(std::size_t tile_vertices, vcg_core::Method method);

/// Bytes that a process needs to smooth a piece, about.
/// @param tile_vertices  of the tile; its surroundings are added
std::uint64_t memory_of_piece(std::size_t tile_vertices, std::size_t vertices, std::size_t faces,
                              vcg_core::Method method);

/// Bytes that making a plan needs, about, but for the pieces that it measures.
std::uint64_t memory_of_plan(std::size_t vertices);

/// Bytes on the disk of a plan with all its results.
/// @param normal_size  bytes of a number of normals, or 0
std::uint64_t disk_bytes(std::size_t vertices, std::size_t faces, std::size_t real_size, std::size_t normal_size);

}  // namespace tiles
