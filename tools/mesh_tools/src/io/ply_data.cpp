// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_data.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <system_error>

#include "formats.h"

namespace mesh_tools::io {
namespace {

using Type = PlyLayout::Type;

/// Rounded once, to the type that the file declares, as MeshLab does.
template <class Real>
bool parse_real(std::string_view word, double& result) {
  const char *first = word.data(), *last = first + word.size();
  if (word.size() > 1 && *first == '+' && word[1] != '-') ++first;
  Real value = 0;
  const auto [stop, error] = std::from_chars(first, last, value);
  if (stop != last || error == std::errc::invalid_argument) return false;
  // Out of range leaves no value: infinity, or something near 0.
  if (error == std::errc::result_out_of_range) {
    const std::string ended(first, last);
    if constexpr (sizeof(Real) == sizeof(float))
      value = std::strtof(ended.c_str(), nullptr);
    else
      value = std::strtod(ended.c_str(), nullptr);
  }
  result = static_cast<double>(value);
  return true;
}

bool fits(std::int64_t value, Type type) {
  return visit_type(type, [value](auto number) {
    using Limits = std::numeric_limits<decltype(number)>;
    if constexpr (Limits::is_integer)
      return value >= Limits::min() && value <= Limits::max();
    else
      return false;
  });
}

bool parse_whole(std::string_view word, Type type, double& result) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size() || !fits(value, type)) return false;
  result = static_cast<double>(value);
  return true;
}

}  // namespace

PlyData::PlyData(const std::string& bytes, const PlyLayout& layout, const std::filesystem::path& path)
    : layout_(layout),
      path_(path),
      data_(bytes.data() + layout.data_offset),
      at_(data_),
      end_(bytes.data() + bytes.size()) {}

/// As text a number takes a digit and a space.
std::size_t PlyData::fewest_bytes(Type type) const {
  return layout_.format == PlyLayout::Format::ascii ? 2 : size_of(type);
}

std::size_t PlyData::most_rows(const PlyLayout::Element& element, const PlyLayout::Property* list,
                               std::size_t entries) const {
  std::size_t bytes = list ? entries * fewest_bytes(list->type) : 0;
  for (const PlyLayout::Property& property : element.properties)
    bytes += fewest_bytes(property.is_list ? property.count_type : property.type);
  return (static_cast<std::size_t>(end_ - at_) + 1) / std::max<std::size_t>(bytes, 1);  // the last space may be missing
}

void PlyData::read(const PlyLayout::Element& element, std::size_t index, Row& row) {
  element_ = &element;
  index_ = index;
  row_ = at_;
  row.number.resize(element.properties.size());
  row.list.resize(element.properties.size());
  row.raw.resize(element.properties.size());
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyLayout::Property& property = element.properties[i];
    if (property.is_list) {
      read_list(property, row.list[i]);
    } else {
      row.number[i] = take(property.type);
      row.raw[i] = taken_;
    }
  }
}

bool PlyData::row_begins_line() const {
  const char* const first_word = std::find_if(row_, end_, [](char c) { return static_cast<unsigned char>(c) > ' '; });
  return row_ == data_ || std::any_of(row_, first_word, [](char c) { return c == '\n' || c == '\r'; });
}

void PlyData::read_list(const PlyLayout::Property& property, std::vector<double>& list) {
  const double count = take(property.count_type);
  if (count < 0) fail_here("has a list of negative length");
  // Before memory is asked for: the length may be wrong.
  if (count * static_cast<double>(fewest_bytes(property.type)) > static_cast<double>(end_ - at_) + 1) fail_cut_off();
  list.resize(static_cast<std::size_t>(count));
  for (double& value : list) value = take(property.type);
}

double PlyData::take(Type type) {
  return layout_.format == PlyLayout::Format::ascii ? take_text(type) : take_binary(type);
}

double PlyData::take_text(Type type) {
  const auto is_space = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
  while (at_ != end_ && is_space(*at_)) ++at_;
  const char* const start = at_;
  while (at_ != end_ && !is_space(*at_)) ++at_;
  if (at_ == start) fail_cut_off();
  const std::string_view word(start, static_cast<std::size_t>(at_ - start));
  taken_ = word;
  double value = 0;
  if (is_whole(type)) {
    if (!parse_whole(word, type, value))
      fail_here("has '" + printable(word) + "' where a whole number of the declared type is needed");
  } else if (!(type == Type::float32 ? parse_real<float>(word, value) : parse_real<double>(word, value))) {
    fail_here("has an entry that cannot be read: '" + printable(word) + "' is not a number");
  }
  return value;
}

double PlyData::take_binary(Type type) {
  const std::size_t size = size_of(type);
  if (size > static_cast<std::size_t>(end_ - at_)) fail_cut_off();
  taken_ = {at_, size};
  at_ += size;
  return visit_type(type, [this](auto number) {
    return static_cast<double>(number_at<decltype(number)>(taken_.data(), is_swapped()));
  });
}

bool PlyData::is_swapped() const {
  return (layout_.format == PlyLayout::Format::big_endian) != is_big_endian_machine();
}

bool PlyData::has_fixed_rows(const PlyLayout::Element& element) const {
  return layout_.format != PlyLayout::Format::ascii &&
         std::none_of(element.properties.begin(), element.properties.end(),
                      [](const PlyLayout::Property& property) { return property.is_list; });
}

PlyData::FixedRows PlyData::take_fixed_rows(const PlyLayout::Element& element) {
  FixedRows rows{at_, 0};
  for (const PlyLayout::Property& property : element.properties) rows.stride += size_of(property.type);
  const auto left = static_cast<std::size_t>(end_ - at_);
  element_ = &element;
  index_ = rows.stride > 0 ? left / rows.stride : element.count;
  if (index_ < element.count) fail_cut_off();
  at_ += rows.stride * element.count;
  return rows;
}

void PlyData::expect_triangles(const PlyLayout::Element& element) {
  const PlyLayout::Property& list = element.properties[0];
  plain_list_ = &element;
  is_plain_list_ = layout_.format != PlyLayout::Format::ascii && !is_swapped() && element.properties.size() == 1 &&
                   list.is_list && size_of(list.count_type) == 1 && is_whole(list.type) && size_of(list.type) == 4;
}

void PlyData::fail_cut_off() const {
  fail(path_, "is cut off: it ends within " + element_->name + " " + std::to_string(index_) + " of " +
                  std::to_string(element_->count));
}

void PlyData::fail_at_row(const PlyLayout::Element& element, std::size_t index, const std::string& what) const {
  fail(path_, element.name + " " + std::to_string(index) + " " + what);
}

}  // namespace mesh_tools::io
