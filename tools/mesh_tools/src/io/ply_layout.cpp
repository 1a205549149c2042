#include "ply_layout.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
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

std::size_t size_of(Type type) {
  switch (type) {
    case Type::int8:
    case Type::uint8:
      return 1;
    case Type::int16:
    case Type::uint16:
      return 2;
    case Type::float64:
      return 8;
    default:
      return 4;
  }
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

/// Longest list that vcglib's buffers take: 32 texture coordinates or colour components, 255 vertices of a face.
std::size_t longest_list(const std::string& element, const std::string& property) {
  if (element == "face" && (property == "texcoord" || property == "color")) return 32;
  if (element == "range_grid") return 5;
  if (element == "tristrips") return SIZE_MAX;
  return 255;
}

void check_list(const std::filesystem::path& path, const PlyLayout::Element& element, std::size_t row,
                const PlyLayout::Property& property, std::int64_t count) {
  const std::string place = element.name + " " + std::to_string(row);
  if (count < 0) fail(path, place + " has a list of negative length");
  if (static_cast<std::size_t>(count) > longest_list(element.name, property.name))
    fail(path, place + " has a list '" + property.name + "' of " + std::to_string(count) + " entries; at most " +
                   std::to_string(longest_list(element.name, property.name)) + " are supported");
  const bool is_polygon = element.name == "face" && property.name.rfind("vertex_ind", 0) == 0;
  if (is_polygon && count < 3) fail(path, place + " has " + std::to_string(count) + " vertices; at least 3 are needed");
}

std::int64_t read_integer(const char* data, Type type, bool big_endian) {
  unsigned char raw[8] = {};
  const std::size_t size = size_of(type);
  std::memcpy(raw, data, size);
  if (big_endian) std::reverse(raw, raw + size);
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = (value << 8) | raw[i];
  switch (type) {
    case Type::int8:
      return static_cast<std::int8_t>(value);
    case Type::int16:
      return static_cast<std::int16_t>(value);
    case Type::int32:
      return static_cast<std::int32_t>(value);
    default:
      return static_cast<std::int64_t>(value);
  }
}

void check_binary(const std::string& bytes, const PlyLayout& layout, const std::filesystem::path& path) {
  const bool big_endian = layout.format == PlyLayout::Format::big_endian;
  std::size_t at = layout.data_offset;
  for (const auto& element : layout.elements) {
    const auto take = [&](std::size_t size, std::size_t row) {
      if (size > bytes.size() - at)
        fail(path, "is cut off: it ends within " + element.name + " " + std::to_string(row) + " of " +
                       std::to_string(element.count));
      at += size;
      return bytes.data() + at - size;
    };
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const auto& property : element.properties) {
        std::size_t count = 1;
        if (property.is_list) {
          const char* data = take(size_of(property.count_type), row);
          const std::int64_t entries = read_integer(data, property.count_type, big_endian);
          check_list(path, element, row, property, entries);
          count = static_cast<std::size_t>(entries);
        }
        take(count * size_of(property.type), row);
      }
    }
  }
}

void check_ascii(const std::string& bytes, const PlyLayout& layout, const std::filesystem::path& path) {
  const char *at = bytes.data() + layout.data_offset, *end = bytes.data() + bytes.size();
  for (const auto& element : layout.elements) {
    const auto take = [&](std::size_t row) {
      while (at != end && static_cast<unsigned char>(*at) <= ' ') ++at;
      const char* start = at;
      while (at != end && static_cast<unsigned char>(*at) > ' ') ++at;
      if (at == start)
        fail(path, "is cut off: it ends within " + element.name + " " + std::to_string(row) + " of " +
                       std::to_string(element.count));
      return std::string(start, at);
    };
    const auto take_number = [&](std::size_t row) {
      const std::string word = take(row);
      char* stop = nullptr;
      const double value = std::strtod(word.c_str(), &stop);
      if (*stop != '\0') fail(path, element.name + " " + std::to_string(row) + ": '" + word + "' is not a number");
      return value;
    };
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const auto& property : element.properties) {
        std::size_t count = 1;
        if (property.is_list) {
          const double entries = take_number(row);
          if (!(entries >= -1 && entries <= 1e9))
            fail(path, element.name + " " + std::to_string(row) + " has a bad list");
          check_list(path, element, row, property, static_cast<std::int64_t>(entries));
          count = static_cast<std::size_t>(entries);
        }
        for (std::size_t k = 0; k < count; ++k) take_number(row);
      }
    }
  }
}

}  // namespace

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

PlyLayout parse_ply_header(const std::string& bytes, const std::filesystem::path& path) {
  PlyLayout layout;
  bool has_format = false;
  std::size_t at = 0;
  for (;;) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos || end - at > 4096) fail(path, "has no PLY header that ends with 'end_header'");
    std::string_view line(bytes.data() + at, end - at);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    at = end + 1;
    const std::size_t number = ++layout.header_lines;
    const Words words = words_of(line);
    if (number == 1) {
      if (words.size() != 1 || words[0] != "ply") fail(path, "is not a PLY file: its first line is not 'ply'");
      continue;
    }
    if (words.empty()) continue;
    const auto bad = [&](const std::string& what) { fail_at_line(path, number, what); };
    if (words[0] == "end_header") break;
    if (words[0] == "comment" || words[0] == "obj_info") {
      layout.comments.emplace_back(line.substr(std::min(line.size(), words[0].size() + 1)));
    } else if (words[0] == "format") {
      if (words.size() < 2) bad("the format is missing");
      if (words[1] == "ascii")
        layout.format = PlyLayout::Format::ascii;
      else if (words[1] == "binary_little_endian")
        layout.format = PlyLayout::Format::little_endian;
      else if (words[1] == "binary_big_endian")
        layout.format = PlyLayout::Format::big_endian;
      else
        bad("unknown format '" + std::string(words[1]) + "'");
      has_format = true;
    } else if (words[0] == "element") {
      if (words.size() < 3) bad("an element needs a name and a count");
      std::size_t count = 0;
      const auto [stop, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
      if (error != std::errc() || stop != words[2].data() + words[2].size() || count > INT32_MAX)
        bad("'" + std::string(words[2]) + "' is not a count of elements");
      layout.elements.push_back({std::string(words[1]), count, {}});
    } else if (words[0] == "property") {
      if (layout.elements.empty()) bad("a property before any element");
      const bool is_list = words.size() == 5 && words[1] == "list";
      if (!is_list && words.size() != 3) bad("a property needs a type and a name");
      const auto type = type_of(words[is_list ? 3 : 1]), count_type = type_of(words[is_list ? 2 : 1]);
      if (!type || !count_type) bad("unknown type of a property");
      if (is_list && (*count_type == Type::float32 || *count_type == Type::float64))
        bad("a list's length is no integer");
      layout.elements.back().properties.push_back({std::string(words.back()), *type, is_list, *count_type});
    } else {
      bad("unknown word '" + std::string(words[0]) + "' in the header");
    }
  }
  if (!has_format) fail(path, "its PLY header has no format line");
  layout.data_offset = at;
  return layout;
}

void check_ply_data(const std::string& bytes, const PlyLayout& layout, const std::filesystem::path& path) {
  if (layout.format == PlyLayout::Format::ascii)
    check_ascii(bytes, layout, path);
  else
    check_binary(bytes, layout, path);
}

std::string to_little_endian(const std::string& bytes, const PlyLayout& layout) {
  std::string result = bytes;
  std::size_t at = layout.data_offset;
  const auto turn = [&](Type type) {
    const std::size_t size = size_of(type);
    std::reverse(result.begin() + static_cast<std::ptrdiff_t>(at),
                 result.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
  };
  for (const auto& element : layout.elements) {
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const auto& property : element.properties) {
        std::int64_t count = 1;
        if (property.is_list) {
          count = read_integer(bytes.data() + at, property.count_type, true);
          turn(property.count_type);
        }
        for (std::int64_t k = 0; k < count; ++k) turn(property.type);
      }
    }
  }
  const std::string word = "binary_big_endian";
  return result.replace(result.find(word), word.size(), "binary_little_endian");
}

}  // namespace mesh_tools::io
