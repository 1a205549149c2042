// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/ply_property.h>

#include "formats.h"
#include "ply_data.h"
#include "ply_layout.h"

namespace mesh_tools {

namespace {

/// Index of the property among those of the vertices.
std::size_t find_property(const io::PlyLayout::Element& vertex, const std::string& name, const OriginalFile& file) {
  std::string known;
  for (std::size_t p = 0; p < vertex.properties.size(); ++p) {
    const auto& property = vertex.properties[p];
    if (property.is_list) continue;
    if (property.name == name) return p;
    known += (known.empty() ? "" : ", ") + io::printable(property.name);
  }
  throw FileError(file.path.string() + " has no vertex property '" + io::printable(name) + "'; it has " + known);
}

}  // namespace

std::vector<double> vertex_property(const OriginalFile& file, const std::string& name) {
  if (extension(file.path) != ".ply")
    throw FileError(file.path.string() + " has no vertex property '" + io::printable(name) +
                    "'; only PLY files have properties");
  const io::PlyLayout layout = io::parse_ply_header(file.bytes, file.path);
  io::PlyData data(file.bytes, layout, file.path);
  io::PlyData::Row row;
  std::vector<double> numbers;
  for (const io::PlyLayout::Element& element : layout.elements) {
    const bool is_vertex = element.name == "vertex";
    const std::size_t property = is_vertex ? find_property(element, name, file) : 0;
    for (std::size_t i = 0; i < element.count; ++i) {
      data.read(element, i, row);
      if (is_vertex) numbers.push_back(row.number[property]);
    }
    if (is_vertex) return numbers;
  }
  throw FileError(file.path.string() + " declares no vertices");
}

}  // namespace mesh_tools
