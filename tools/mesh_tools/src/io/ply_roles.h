#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "ply_layout.h"

/// What the properties of PLY's vertices and faces mean, by name and type.
namespace mesh_tools::io {

/// What a property says of a vertex or a face.
enum class Role { none, x, y, z, nx, ny, nz, flags, quality, radius, red, green, blue, alpha, gray, u, v, page };

enum class Kind { real, whole, byte };

struct KnownProperty {
  const char* name;
  Role role;
  Kind kind;
};
/// The first of several properties with one role is the one that counts.
inline constexpr KnownProperty known_of_vertex[] = {{"x", Role::x, Kind::real},
                                                    {"y", Role::y, Kind::real},
                                                    {"z", Role::z, Kind::real},
                                                    {"nx", Role::nx, Kind::real},
                                                    {"ny", Role::ny, Kind::real},
                                                    {"nz", Role::nz, Kind::real},
                                                    {"flags", Role::flags, Kind::whole},
                                                    {"quality", Role::quality, Kind::real},
                                                    {"confidence", Role::quality, Kind::real},
                                                    {"radius", Role::radius, Kind::real},
                                                    {"red", Role::red, Kind::byte},
                                                    {"green", Role::green, Kind::byte},
                                                    {"blue", Role::blue, Kind::byte},
                                                    {"alpha", Role::alpha, Kind::byte},
                                                    {"diffuse_red", Role::red, Kind::byte},
                                                    {"diffuse_green", Role::green, Kind::byte},
                                                    {"diffuse_blue", Role::blue, Kind::byte},
                                                    {"diffuse_alpha", Role::alpha, Kind::byte},
                                                    {"intensity", Role::gray, Kind::real},
                                                    {"texture_u", Role::u, Kind::real},
                                                    {"texture_v", Role::v, Kind::real},
                                                    {"s", Role::u, Kind::real},
                                                    {"t", Role::v, Kind::real}};
inline constexpr KnownProperty known_of_face[] = {
    {"flags", Role::flags, Kind::whole}, {"quality", Role::quality, Kind::real}, {"texnumber", Role::page, Kind::whole},
    {"red", Role::red, Kind::byte},      {"green", Role::green, Kind::byte},     {"blue", Role::blue, Kind::byte},
    {"alpha", Role::alpha, Kind::byte},  {"nx", Role::nx, Kind::real},           {"ny", Role::ny, Kind::real},
    {"nz", Role::nz, Kind::real}};

bool is_of_kind(PlyLayout::Type type, Kind kind);

/// Whether a property lists the corners of a face.
bool is_corner_list(const PlyLayout::Property& property);

/// A fraction of 255 as a byte; 0 if it is not a number.
unsigned char to_byte(double value);

/// The roles of an element's numbers, by index of property.
class Roles {
 public:
  template <std::size_t N>
  Roles(const PlyLayout::Element& element, const KnownProperty (&table)[N]) : roles_(element.properties.size()) {
    for (const KnownProperty& known : table)
      for (std::size_t i = 0; i < roles_.size(); ++i) {
        const PlyLayout::Property& property = element.properties[i];
        if (!property.is_list && property.name == known.name && is_of_kind(property.type, known.kind) &&
            !has(known.role))
          roles_[i] = known.role;
      }
  }

  Role operator[](std::size_t property) const { return roles_[property]; }
  bool has(Role role) const { return std::find(roles_.begin(), roles_.end(), role) != roles_.end(); }
  bool has_normal() const { return has(Role::nx) && has(Role::ny) && has(Role::nz); }

 private:
  std::vector<Role> roles_;
};

}  // namespace mesh_tools::io
