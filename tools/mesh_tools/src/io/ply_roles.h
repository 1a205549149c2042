// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "ply_layout.h"

/// What the properties of PLY's vertices and faces mean, by name and type.
namespace mesh_tools::io {

/// What a property says of a vertex or a face.
enum class Role { none, x, y, z, nx, ny, nz, flags, quality, radius, red, green, blue, alpha, gray, u, v, page };

/// Colours may be of any type but the one in which 255 is -1.
enum class Kind { real, whole, number, color };

struct KnownProperty {
  const char* name;
  Role role;
  Kind kind;
};
/// The first of several properties with one role is the one that counts.
inline constexpr KnownProperty known_of_vertex[] = {{"x", Role::x, Kind::number},
                                                    {"y", Role::y, Kind::number},
                                                    {"z", Role::z, Kind::number},
                                                    {"nx", Role::nx, Kind::real},
                                                    {"ny", Role::ny, Kind::real},
                                                    {"nz", Role::nz, Kind::real},
                                                    {"flags", Role::flags, Kind::whole},
                                                    {"quality", Role::quality, Kind::real},
                                                    {"confidence", Role::quality, Kind::real},
                                                    {"radius", Role::radius, Kind::real},
                                                    {"red", Role::red, Kind::color},
                                                    {"green", Role::green, Kind::color},
                                                    {"blue", Role::blue, Kind::color},
                                                    {"alpha", Role::alpha, Kind::color},
                                                    {"r", Role::red, Kind::color},
                                                    {"g", Role::green, Kind::color},
                                                    {"b", Role::blue, Kind::color},
                                                    {"a", Role::alpha, Kind::color},
                                                    {"diffuse_red", Role::red, Kind::color},
                                                    {"diffuse_green", Role::green, Kind::color},
                                                    {"diffuse_blue", Role::blue, Kind::color},
                                                    {"diffuse_alpha", Role::alpha, Kind::color},
                                                    {"intensity", Role::gray, Kind::real},
                                                    {"texture_u", Role::u, Kind::real},
                                                    {"texture_v", Role::v, Kind::real},
                                                    {"u", Role::u, Kind::real},
                                                    {"v", Role::v, Kind::real},
                                                    {"s", Role::u, Kind::real},
                                                    {"t", Role::v, Kind::real},
                                                    {"texcoord_u", Role::u, Kind::real},
                                                    {"texcoord_v", Role::v, Kind::real}};
inline constexpr KnownProperty known_of_face[] = {
    {"flags", Role::flags, Kind::whole},    {"quality", Role::quality, Kind::real},
    {"texnumber", Role::page, Kind::whole}, {"red", Role::red, Kind::color},
    {"green", Role::green, Kind::color},    {"blue", Role::blue, Kind::color},
    {"alpha", Role::alpha, Kind::color},    {"r", Role::red, Kind::color},
    {"g", Role::green, Kind::color},        {"b", Role::blue, Kind::color},
    {"a", Role::alpha, Kind::color},        {"nx", Role::nx, Kind::real},
    {"ny", Role::ny, Kind::real},           {"nz", Role::nz, Kind::real}};

bool is_of_kind(PlyLayout::Type type, Kind kind);

/// Names of one letter may mean anything: r, g, b and u, v only mean what they say where all of them are there.
bool is_meant(const PlyLayout::Element& element, const std::string& name);

/// Whether a property lists the corners of a face.
bool is_corner_list(const PlyLayout::Property& property);

/// The roles of an element's numbers, by index of property.
class Roles {
 public:
  template <std::size_t N>
  Roles(const PlyLayout::Element& element, const KnownProperty (&table)[N]) : roles_(element.properties.size()) {
    for (const KnownProperty& known : table)
      for (std::size_t i = 0; i < roles_.size(); ++i) {
        const PlyLayout::Property& property = element.properties[i];
        if (!property.is_list && property.name == known.name && is_of_kind(property.type, known.kind) &&
            !has(known.role) && is_meant(element, property.name))
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
