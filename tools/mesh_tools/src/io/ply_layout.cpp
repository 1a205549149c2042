// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_layout.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <string_view>

#include "formats.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

using Type = PlyLayout::Type;
using Words = std::vector<std::string_view>;

std::optional<Type> type_of(std::string_view name) {
  struct Entry {
    const char *name, *other_name;
    Type type;
  };
  static constexpr Entry table[] = {{"char", "int8", Type::int8},        {"uchar", "uint8", Type::uint8},
                                    {"short", "int16", Type::int16},     {"ushort", "uint16", Type::uint16},
                                    {"int", "int32", Type::int32},       {"uint", "uint32", Type::uint32},
                                    {"float", "float32", Type::float32}, {"double", "float64", Type::float64}};
  for (const Entry& entry : table)
    if (name == entry.name || name == entry.other_name) return entry.type;
  return std::nullopt;
}

Words words_of(std::string_view line) {
  Words words;
  std::size_t i = 0;
  while (i < line.size()) {
    while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
    const std::size_t start = i;
    while (i < line.size() && line[i] != ' ' && line[i] != '\t') ++i;
    if (i > start) words.push_back(line.substr(start, i - start));
  }
  return words;
}

/// Without control characters, as it becomes part of messages.
bool is_name(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](unsigned char c) { return c > ' ' && c != 0x7f; });
}

}  // namespace

bool is_whole(Type type) { return type != Type::float32 && type != Type::float64; }

const PlyLayout::Property* PlyLayout::Element::find(const std::string& property) const {
  for (const Property& candidate : properties)
    if (candidate.name == property) return &candidate;
  return nullptr;
}

const PlyLayout::Element* PlyLayout::find(const std::string& element) const {
  for (const Element& candidate : elements)
    if (candidate.name == element) return &candidate;
  return nullptr;
}

namespace {

/// Whether a header line of an unknown word seems to declare something: then it cannot be passed over.
bool may_declare(const Words& words) {
  constexpr std::string_view keywords[] = {"format", "element", "property", "list", "vertex", "face", "end_header"};
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return type_of(word) || std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
  });
}

/// The lines of a header. They end in LF, CR LF or CR; the first tells which, for behind the last anything may come.
class HeaderLines {
 public:
  HeaderLines(const std::string& bytes, const std::filesystem::path& path)
      : bytes_(bytes), path_(path), at_(byte_order_mark(bytes)) {}

  std::string_view next() {
    const auto [line, size] = first_line(std::string_view(bytes_).substr(at_));
    if (size == line.size()) fail(path_, "has no PLY header that ends with 'end_header'");
    if (!knows_end_ && !line.empty()) {
      knows_end_ = true;
      ends_in_cr_ = bytes_[at_ + size - 1] == '\r';
    }
    at_ += ends_in_cr_ ? line.size() + 1 : size;
    ++number_;
    return line;
  }

  std::size_t number() const { return number_; }
  std::size_t at() const { return at_; }

 private:
  const std::string& bytes_;
  const std::filesystem::path& path_;
  bool knows_end_ = false, ends_in_cr_ = false;
  std::size_t at_, number_ = 0;
};

}  // namespace

std::vector<std::string_view> texture_names(const PlyLayout& layout) {
  constexpr std::string_view keyword = "TextureFile ";
  std::vector<std::string_view> names;
  for (const std::string_view comment : layout.comments)
    if (comment.substr(0, keyword.size()) == keyword) names.push_back(comment.substr(keyword.size()));
  return names;
}

PlyLayout parse_ply_header(const std::string& bytes, const std::filesystem::path& path) {
  PlyLayout layout;
  bool has_format = false, has_begun = false;
  HeaderLines lines(bytes, path);
  for (;;) {
    const std::string_view line = lines.next();
    const std::size_t number = lines.number();
    const Words words = words_of(line);
    if (!has_begun) {
      if (words.empty()) continue;
      if (words.size() != 1 || words[0] != "ply") fail(path, "is not a PLY file: its first line is not 'ply'");
      has_begun = true;
      continue;
    }
    if (words.empty()) continue;
    const auto bad = [&](const std::string& what) { fail_at_line(path, number, what); };
    constexpr std::size_t most_lines = 10000;
    if (number > most_lines) bad("the header has more than " + std::to_string(most_lines) + " lines");
    if (words[0] == "end_header") break;
    if (words[0] == "comment" || words[0] == "obj_info") {
      layout.comments.push_back(line.substr(std::min(line.size(), words[0].size() + 1)));
    } else if (words[0] == "format") {
      if (words.size() < 2) bad("the format is missing");
      if (words[1] == "ascii")
        layout.format = PlyLayout::Format::ascii;
      else if (words[1] == "binary_little_endian")
        layout.format = PlyLayout::Format::little_endian;
      else if (words[1] == "binary_big_endian")
        layout.format = PlyLayout::Format::big_endian;
      else
        bad("unknown format '" + printable(words[1]) + "'");
      has_format = true;
    } else if (words[0] == "element") {
      if (words.size() < 3 || !is_name(words[1])) bad("an element needs a name and a count");
      std::size_t count = 0;
      const auto [stop, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
      if (error != std::errc() || stop != words[2].data() + words[2].size() || count > INT32_MAX)
        bad("'" + printable(words[2]) + "' is not a count of elements");
      if (layout.find(std::string(words[1]))) bad("element '" + printable(words[1]) + "' is declared twice");
      layout.elements.push_back({std::string(words[1]), count, {}});
    } else if (words[0] == "property") {
      if (layout.elements.empty()) bad("a property before any element");
      const bool is_list = words.size() == 5 && words[1] == "list";
      if ((!is_list && words.size() != 3) || !is_name(words.back())) bad("a property needs a type and a name");
      const auto type = type_of(words[is_list ? 3 : 1]), count_type = type_of(words[is_list ? 2 : 1]);
      if (!type || !count_type) bad("unknown type of a property");
      if (is_list && !is_whole(*count_type)) bad("a list's length is no integer");
      PlyLayout::Element& element = layout.elements.back();
      if (element.find(std::string(words.back()))) bad("property '" + printable(words.back()) + "' is declared twice");
      element.properties.push_back({std::string(words.back()), *type, is_list, *count_type});
    } else if (may_declare(words)) {
      bad("unknown word '" + printable(words[0]) + "' in the header");
    } else {
      layout.warnings.push_back("line " + std::to_string(number) + " of the header, '" + printable(line) +
                                "', declares nothing and is passed over");
    }
  }
  if (!has_format) fail(path, "its PLY header has no format line");
  for (const auto& element : layout.elements)
    if (element.count > 0 && element.properties.empty())
      fail(path, "declares element '" + element.name + "' without any property");
  layout.data_offset = lines.at();
  return layout;
}

}  // namespace mesh_tools::io
