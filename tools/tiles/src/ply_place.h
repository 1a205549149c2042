// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "input_file.h"
#include "io/ply_layout.h"

namespace tiles {

/// Rows of one size in a file, and where the three coordinates of a row are.
struct RowPlace {
  std::uint64_t begin = 0;
  std::size_t stride = 0;
  std::array<std::size_t, 3> offset{};
  std::array<bool, 3> in_double{};
  bool swapped = false;  ///< whether the bytes of numbers are in the other order than this machine's

  double coordinate(const char* row, std::size_t axis) const;
  /// Puts a number into a row; the same number keeps its bytes.
  void put(char* row, std::size_t axis, double value) const;
};

/// A PLY element, its numbers in binary.
struct PlyRows {
  mesh_tools::io::PlyLayout::Element element;
  bool swapped = false;
  bool of_one_size = true;  ///< whether it has no lists
  std::size_t stride = 0;   ///< of a row that has none
  std::size_t corners = 0;  ///< index of the property that lists a face's corners

  PlyRows(const mesh_tools::io::PlyLayout& layout, const mesh_tools::io::PlyLayout::Element& which);

  /// Takes a row from the reader, and gives its list `corners`, three indices.
  /// @throws mesh_tools::FileError: other than three
  std::array<std::uint32_t, 3> read_triangle(SequentialReader& reader, std::size_t index, std::size_t vertices,
                                             const std::filesystem::path& path) const;
  /// Takes a row, and gives the whole number of that name in it; 0 if there is none.
  std::int64_t read_number(SequentialReader& reader, std::string_view name) const;
};

/// Where three numbers of the vertices are.
/// @throws mesh_tools::FileError: they are missing, whole numbers, or among lists
RowPlace vertex_place(const PlyRows& rows, const std::array<const char*, 3>& names, std::uint64_t begin,
                      const std::filesystem::path& path);

}  // namespace tiles
