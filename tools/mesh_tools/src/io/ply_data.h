// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "binary.h"
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

  /// Rows that all have the same size: of binary files, of an element without lists.
  struct FixedRows {
    const char* begin;
    std::size_t stride;
  };
  bool has_fixed_rows(const PlyLayout::Element& element) const;
  /// Takes all rows of such an element.
  FixedRows take_fixed_rows(const PlyLayout::Element& element);

  /// Calls visit(row, number) for the numbers of one property of such rows, in their order.
  template <class Visit>
  void visit_numbers(const PlyLayout::Element& element, std::size_t property, const FixedRows& rows,
                     const Visit& visit) const;

  /// Takes row `index` if it is three whole numbers of 32 bits below `limit`, and nothing else; false, and nothing
  /// taken, if it is not or the file does not say so plainly.
  bool take_triangle(const PlyLayout::Element& element, std::uint32_t limit, std::array<std::uint32_t, 3>& corners) {
    if (!is_plain_list_ || static_cast<std::size_t>(end_ - at_) < 13 || *at_ != 3 || &element != plain_list_)
      return false;
    std::memcpy(corners.data(), at_ + 1, 12);
    if (corners[0] >= limit || corners[1] >= limit || corners[2] >= limit) return false;
    at_ += 13;
    return true;
  }
  /// Says which element take_triangle() will be asked for.
  void expect_triangles(const PlyLayout::Element& element);

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
  template <class Number, class Visit>
  void visit_as(const char* at, std::size_t stride, std::size_t count, const Visit& visit) const;
  bool is_swapped() const;

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
  const char* row_ = nullptr;  // where the last row begins
  std::string_view taken_;     // bytes of the last number
  bool is_plain_list_ = false;
  const PlyLayout::Element* plain_list_ = nullptr;
  const PlyLayout::Element* element_ = nullptr;  // where fail_here() is
  std::size_t index_ = 0;
};

template <class Number, class Visit>
void PlyData::visit_as(const char* at, std::size_t stride, std::size_t count, const Visit& visit) const {
  const bool swapped = is_swapped();
  for (std::size_t i = 0; i < count; ++i, at += stride) visit(i, static_cast<double>(number_at<Number>(at, swapped)));
}

template <class Visit>
void PlyData::visit_numbers(const PlyLayout::Element& element, std::size_t property, const FixedRows& rows,
                            const Visit& visit) const {
  const char* at = rows.begin;
  for (std::size_t p = 0; p < property; ++p) at += size_of(element.properties[p].type);
  visit_type(element.properties[property].type,
             [&](auto number) { visit_as<decltype(number)>(at, rows.stride, element.count, visit); });
}

}  // namespace mesh_tools::io
