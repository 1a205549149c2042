// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_roles.h"

namespace mesh_tools::io {

bool is_of_kind(PlyLayout::Type type, Kind kind) {
  switch (kind) {
    case Kind::number:
      return true;
    case Kind::color:
      return type != PlyLayout::Type::int8;
    default:
      return (kind == Kind::whole) == is_whole(type);
  }
}

bool is_meant(const PlyLayout::Element& element, const std::string& name) {
  if (name == "r" || name == "g" || name == "b" || name == "a")
    return element.find("r") && element.find("g") && element.find("b");
  if (name == "u" || name == "v") return element.find("u") && element.find("v");
  return true;
}

bool is_corner_list(const PlyLayout::Property& property) {
  return property.is_list && is_whole(property.type) &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

}  // namespace mesh_tools::io
