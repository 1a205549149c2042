// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mesh_tools::io {

/// What a PLY file declares.
struct PlyLayout {
  enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
  enum class Format { ascii, little_endian, big_endian };
  struct Property {
    std::string name;
    Type type;
    bool is_list = false;
    Type count_type = Type::uint8;
  };
  struct Element {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;

    const Property* find(const std::string& property) const;
  };

  Format format = Format::ascii;
  std::vector<Element> elements;
  std::vector<std::string_view> comments;  ///< and obj_info; parts of the file
  std::size_t data_offset = 0;
  std::vector<std::string> warnings;  ///< what is odd about the header, without the file's name

  const Element* find(const std::string& element) const;
};

/// Names of texture files, which stand in comments; parts of the file.
std::vector<std::string_view> texture_names(const PlyLayout& layout);

bool is_whole(PlyLayout::Type type);

/// Calls visit(number) with a number of the type, whatever its value.
template <class Visit>
decltype(auto) visit_type(PlyLayout::Type type, const Visit& visit) {
  switch (type) {
    case PlyLayout::Type::int8:  // NOLINT(bugprone-branch-clone): the same text, of another type each
      return visit(std::int8_t());
    case PlyLayout::Type::uint8:
      return visit(std::uint8_t());
    case PlyLayout::Type::int16:
      return visit(std::int16_t());
    case PlyLayout::Type::uint16:
      return visit(std::uint16_t());
    case PlyLayout::Type::int32:
      return visit(std::int32_t());
    case PlyLayout::Type::uint32:
      return visit(std::uint32_t());
    case PlyLayout::Type::float32:
      return visit(float());
    default:
      return visit(double());
  }
}

inline std::size_t size_of(PlyLayout::Type type) {
  return visit_type(type, [](auto number) { return sizeof number; });
}

/// Reads the header and throws FileError where it is not one. Passed over are a byte order mark, empty lines before the
/// word ply, and lines that declare nothing.
PlyLayout parse_ply_header(const std::string& bytes, const std::filesystem::path& path);

}  // namespace mesh_tools::io
