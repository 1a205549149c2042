// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_place.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "fail.h"
#include "io/binary.h"
#include "io/formats.h"
#include "io/ply_roles.h"

namespace tiles {
namespace {

using mesh_tools::io::number_at;
using mesh_tools::io::PlyLayout;
using Type = PlyLayout::Type;

template <class Real>
void store(char* raw, double value, bool swapped) {
  const Real before = number_at<Real>(raw, swapped), now = static_cast<Real>(value);
  if (before == now) return;  // 0 and -0 have other bytes
  mesh_tools::io::put_number(raw, now, swapped);
}

std::int64_t whole_number(const char* raw, Type type, bool swapped) {
  switch (type) {
    case Type::int8:
      return number_at<std::int8_t>(raw, false);
    case Type::uint8:
      return number_at<std::uint8_t>(raw, false);
    case Type::int16:
      return number_at<std::int16_t>(raw, swapped);
    case Type::uint16:
      return number_at<std::uint16_t>(raw, swapped);
    case Type::int32:
      return number_at<std::int32_t>(raw, swapped);
    case Type::uint32:
      return number_at<std::uint32_t>(raw, swapped);
    default:
      return -1;  // no count and no index
  }
}

}  // namespace

double RowPlace::coordinate(const char* row, std::size_t axis) const {
  const char* const raw = row + offset[axis];
  return in_double[axis] ? number_at<double>(raw, swapped) : static_cast<double>(number_at<float>(raw, swapped));
}

void RowPlace::put(char* row, std::size_t axis, double value) const {
  char* const raw = row + offset[axis];
  if (in_double[axis])
    store<double>(raw, value, swapped);
  else
    store<float>(raw, value, swapped);
}

PlyRows::PlyRows(const PlyLayout& layout, const PlyLayout::Element& which)
    : element(which),
      swapped((layout.format == PlyLayout::Format::big_endian) != mesh_tools::io::is_big_endian_machine()) {
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyLayout::Property& property = element.properties[p];
    if (property.is_list) of_one_size = false;
    stride += mesh_tools::io::size_of(property.type);
  }
  const auto list = std::find_if(element.properties.begin(), element.properties.end(), mesh_tools::io::is_corner_list);
  corners = static_cast<std::size_t>(list - element.properties.begin());
}

std::array<std::uint32_t, 3> PlyRows::read_triangle(SequentialReader& reader, std::size_t index, std::size_t vertices,
                                                    const std::filesystem::path& path) const {
  std::array<std::uint32_t, 3> triangle{};
  const auto refuse = [&](const std::string& what) { fail(path, "face " + std::to_string(index) + " " + what); };
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyLayout::Property& property = element.properties[p];
    const std::size_t size = mesh_tools::io::size_of(property.type);
    if (!property.is_list) {
      reader.take(size);
      continue;
    }
    const std::int64_t count =
        whole_number(reader.take(mesh_tools::io::size_of(property.count_type)), property.count_type, swapped);
    if (count < 0) refuse("has a list of negative length");
    if (p != corners) {
      for (std::int64_t i = 0; i < count; ++i) reader.take(size);
      continue;
    }
    if (count != 3) refuse("has " + std::to_string(count) + " corners; only triangles can be cut into pieces");
    const char* const raw = reader.take(3 * size);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t vertex = whole_number(raw + k * size, property.type, swapped);
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertices))
        refuse("has vertex index " + std::to_string(vertex) + "; allowed are 0 to " + std::to_string(vertices - 1));
      triangle[k] = static_cast<std::uint32_t>(vertex);
    }
  }
  return triangle;
}

std::int64_t PlyRows::read_number(SequentialReader& reader, std::string_view name) const {
  std::int64_t number = 0;
  for (const PlyLayout::Property& property : element.properties) {
    const std::size_t size = mesh_tools::io::size_of(property.type);
    std::int64_t count = 1;
    if (property.is_list)
      count = whole_number(reader.take(mesh_tools::io::size_of(property.count_type)), property.count_type, swapped);
    for (std::int64_t i = 0; i < count; ++i) {
      const char* const raw = reader.take(size);
      if (!property.is_list && property.name == name && mesh_tools::io::is_whole(property.type))
        number = whole_number(raw, property.type, swapped);
    }
  }
  return number;
}

RowPlace vertex_place(const PlyRows& rows, const std::array<const char*, 3>& names, std::uint64_t begin,
                      const std::filesystem::path& path) {
  RowPlace place;
  place.begin = begin;
  place.stride = rows.stride;
  place.swapped = rows.swapped;
  if (!rows.of_one_size) fail(path, "its vertices have lists; such files cannot be cut into pieces");
  for (std::size_t k = 0; k < 3; ++k) {
    const PlyLayout::Property* const found = rows.element.find(names[k]);
    if (found == nullptr) fail(path, std::string("vertex property '") + names[k] + "' must be there and be a number");
    if (mesh_tools::io::is_whole(found->type))
      fail(path, "its coordinates are whole numbers; those of the result are not, so it cannot be cut into pieces");
    for (const PlyLayout::Property& property : rows.element.properties) {
      if (&property == found) break;
      place.offset[k] += mesh_tools::io::size_of(property.type);
    }
    place.in_double[k] = found->type == Type::float64;
  }
  return place;
}

}  // namespace tiles
