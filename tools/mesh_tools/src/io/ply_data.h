// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ply_layout.h"

namespace mesh_tools::io {

/// Hands out the data behind a PLY header row by row, text and binary in both byte orders alike. Every number is
/// checked: that it is there, is a number, and fits the type that the header declares. Throws FileError.
class PlyData {
 public:
  /// All three are referred to, not copied.
  PlyData(const std::string& bytes, const PlyLayout& layout, const std::filesystem::path& path);

  /// One row: a list for each property that is one, a number for each other; by index of property.
  struct Row {
    std::vector<double> number;
    std::vector<std::vector<double>> list;
    std::vector<std::string_view> raw;  ///< the bytes of each number
  };

  /// Reads row `index` of `element`; to be called for all rows in the order of the file.
  void read(const PlyLayout::Element& element, std::size_t index, Row& row);

  /// Of text: whether the last row begins a line, as every row does in a sound file.
  bool row_begins_line() const;

  /// How many bytes of the file are behind the last row.
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  /// How many rows of `element` what is left of the file can hold, if `list` has at least so many entries in each.
  std::size_t most_rows(const PlyLayout::Element& element, const PlyLayout::Property* list = nullptr,
                        std::size_t entries = 0) const;

  /// "element ROW what" as a FileError.
  [[noreturn]] void fail_at_row(const PlyLayout::Element& element, std::size_t index, const std::string& what) const;

 private:
  double take(PlyLayout::Type type);
  double take_text(PlyLayout::Type type);
  double take_binary(PlyLayout::Type type);
  void read_list(const PlyLayout::Property& property, std::vector<double>& list);
  std::size_t fewest_bytes(PlyLayout::Type type) const;
  [[noreturn]] void fail_cut_off() const;
  [[noreturn]] void fail_here(const std::string& what) const { fail_at_row(*element_, index_, what); }

  const PlyLayout& layout_;
  const std::filesystem::path& path_;
  const char *data_, *at_, *end_;
  const char* row_ = nullptr;                    // where the last row begins
  std::string_view taken_;                       // bytes of the last number
  const PlyLayout::Element* element_ = nullptr;  // where fail_here() is
  std::size_t index_ = 0;
};

}  // namespace mesh_tools::io
