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
std::size_t size_of(PlyLayout::Type type);

/// Reads the header and throws FileError where it is not one. Passed over are a byte order mark, empty lines before the
/// word ply, and lines that declare nothing.
PlyLayout parse_ply_header(const std::string& bytes, const std::filesystem::path& path);

}  // namespace mesh_tools::io
