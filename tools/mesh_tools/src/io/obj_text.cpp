// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Wavefront OBJ: v (with colour), vt, vn, f, l, and a material for each colour and texture of faces.

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "formats.h"
#include "polygons.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

/// Colour and texture of a face, as the material file names them.
struct FaceMaterial {
  std::array<unsigned char, 4> color;
  std::string texture;

  bool operator<(const FaceMaterial& other) const {
    return std::tie(color, texture) < std::tie(other.color, other.texture);
  }
};

/// Scalar is what positions and normals are rounded to.
template <class Scalar>
class ObjText {
 public:
  ObjText(const FlatFile& file, const std::vector<std::string>& textures)
      : file_(file), texture_names_(textures), mesh_(file.mesh), attributes_(file.attributes) {}

  std::map<FaceMaterial, std::size_t> materials;

  std::string text(const std::string& material_name) {
    const bool has_materials = attributes_ & (face_color | wedge_texture | vertex_texture);
    if (has_materials) text_ += "mtllib " + material_name + "\n";
    append_vertices();
    std::size_t current = mesh_.face.size();  // none: there are never more materials than faces
    visit_polygons(file_, [&](std::size_t face, const std::uint32_t* first, const std::uint32_t* last) {
      if (has_materials) {
        const FaceMaterial look = material_of(face);
        const std::size_t material = materials.try_emplace(look, materials.size()).first->second;
        if (material != current) text_ += "usemtl material_" + std::to_string(material) + "\n";
        current = material;
      }
      append_polygon(face, first, last);
    });
    if (attributes_ & edges)
      for (const auto& [a, b] : mesh_.edge)
        text_ += "l " + std::to_string(a + std::uint64_t(1)) + " " + std::to_string(b + std::uint64_t(1)) + "\n";
    return std::move(text_);
  }

 private:
  FaceMaterial material_of(std::size_t face) const {
    FaceMaterial material{{255, 255, 255, 255}, {}};
    if (attributes_ & face_color)
      for (int k = 0; k < 4; ++k) material.color[k] = mesh_.face_color[face][k];
    const int page = has_vertex_texture() || mesh_.face_page.empty() ? 0 : mesh_.face_page[face];
    if (has_texture(face) && page >= 0 && static_cast<std::size_t>(page) < texture_names_.size())
      material.texture = texture_names_[page];
    return material;
  }

  /// The format knows those of corners only.
  bool has_vertex_texture() const { return (attributes_ & vertex_texture) && !(attributes_ & wedge_texture); }

  bool has_texture(std::size_t face) const {
    return has_vertex_texture() || ((attributes_ & wedge_texture) && is_textured(mesh_, face));
  }

  void append(double value) { append_number(text_ += ' ', value); }

  void append_vertices() {
    for (std::size_t v = 0; v < mesh_.vertices(); ++v) {
      text_ += 'v';
      for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(mesh_.position.number(v, k)));
      if (attributes_ & vertex_color)
        for (int k = 0; k < 3; ++k) append(mesh_.vertex_color[v][k] / 255.0);
      text_ += '\n';
      if (!(attributes_ & vertex_normal)) continue;
      text_ += "vn";
      for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(mesh_.vertex_normal.number(v, k)));
      text_ += '\n';
    }
  }

  std::size_t texture_number(std::size_t face, std::size_t k) {
    const FlatMesh::TextureCoordinate& own =
        has_vertex_texture() ? mesh_.vertex_texture[mesh_.face[face][k]] : mesh_.wedge_texture[face][k];
    const std::pair<float, float> place(own.u, own.v);
    const auto [entry, is_new] = textures_.try_emplace(place, textures_.size() + 1);
    if (is_new) {
      text_ += "vt";
      append(place.first);
      append(place.second);
      text_ += '\n';
    }
    return entry->second;
  }

  /// A corner's texture coordinate may have to be written before the face.
  void append_polygon(std::size_t first_face, const std::uint32_t* first, const std::uint32_t* last) {
    const bool textured = has_texture(first_face), normals = attributes_ & vertex_normal;
    line_ = "f";
    for (; first != last; ++first) {
      const std::size_t face = *first / 3, k = *first % 3;
      const std::uint64_t vertex = mesh_.face[face][k] + std::uint64_t(1);
      append_whole(line_ += ' ', vertex);
      if (textured || normals) line_ += '/';
      if (textured) append_whole(line_, texture_number(face, k));
      if (normals) append_whole(line_ += '/', vertex);
    }
    text_.append(line_).append("\n");
  }

  const FlatFile& file_;
  const std::vector<std::string>& texture_names_;
  const FlatMesh& mesh_;
  int attributes_;
  std::string text_, line_;
  std::map<std::pair<float, float>, std::size_t> textures_;
};

std::string material_text(const std::map<FaceMaterial, std::size_t>& materials) {
  std::string text;
  for (const auto& [material, number] : materials) {
    text += "newmtl material_" + std::to_string(number) + "\nKd";
    for (int k = 0; k < 3; ++k) append_number(text += ' ', material.color[k] / 255.0);
    append_number(text += "\nd ", material.color[3] / 255.0);
    text += '\n';
    if (!material.texture.empty()) text += "map_Kd " + material.texture + "\n";
  }
  return text;
}

template <class Scalar>
ObjBytes bytes_of(const FlatFile& file, const std::vector<std::string>& textures, const std::string& material_name) {
  ObjText<Scalar> obj(file, textures);
  std::string mesh = obj.text(material_name);
  return {std::move(mesh), material_text(obj.materials)};
}

}  // namespace

ObjBytes obj_bytes(const FlatFile& file, const std::vector<std::string>& textures, const std::string& material_name) {
  return file.precision == Precision::double_precision ? bytes_of<double>(file, textures, material_name)
                                                       : bytes_of<float>(file, textures, material_name);
}

}  // namespace mesh_tools::io
