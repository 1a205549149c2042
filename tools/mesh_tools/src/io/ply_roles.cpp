#include "ply_roles.h"

namespace mesh_tools::io {

bool is_of_kind(PlyLayout::Type type, Kind kind) {
  return kind == Kind::real ? !is_whole(type) : kind == Kind::whole ? is_whole(type) : type == PlyLayout::Type::uint8;
}

bool is_corner_list(const PlyLayout::Property& property) {
  return property.is_list && is_whole(property.type) &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

unsigned char to_byte(double value) { return value > 0 ? static_cast<unsigned char>(std::min(value, 255.0)) : 0; }

}  // namespace mesh_tools::io
