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
  ObjText(const MeshFile& file, const std::vector<std::string>& textures)
      : file_(file), texture_names_(textures), mesh_(file.mesh), attributes_(file.attributes) {}

  std::map<FaceMaterial, std::size_t> materials;

  std::string text(const std::string& material_name) {
    const bool has_materials = attributes_ & (face_color | wedge_texture | vertex_texture);
    if (has_materials) text_ += "mtllib " + material_name + "\n";
    append_vertices();
    std::size_t current = mesh_.face.size();  // none: there are never more materials than faces
    visit_polygons(file_, [&](std::size_t face, const std::uint32_t* first, const std::uint32_t* last) {
      if (has_materials) {
        const FaceMaterial look = material_of(mesh_.face[face]);
        const std::size_t material = materials.try_emplace(look, materials.size()).first->second;
        if (material != current) text_ += "usemtl material_" + std::to_string(material) + "\n";
        current = material;
      }
      append_polygon(mesh_.face[face], first, last);
    });
    for (const auto& edge : mesh_.edge)
      if (!edge.IsD() && (attributes_ & edges))
        text_ += "l " + std::to_string(number_[vcg::tri::Index(mesh_, edge.cV(0))]) + " " +
                 std::to_string(number_[vcg::tri::Index(mesh_, edge.cV(1))]) + "\n";
    return std::move(text_);
  }

 private:
  FaceMaterial material_of(const detail::FaceD& face) const {
    FaceMaterial material{{255, 255, 255, 255}, {}};
    if (attributes_ & face_color)
      for (int k = 0; k < 4; ++k) material.color[k] = face.cC()[k];
    const int page = has_vertex_texture() ? 0 : face.cWT(0).n();
    if (has_texture(face) && page >= 0 && static_cast<std::size_t>(page) < texture_names_.size())
      material.texture = texture_names_[page];
    return material;
  }

  /// The format knows those of corners only.
  bool has_vertex_texture() const { return (attributes_ & vertex_texture) && !(attributes_ & wedge_texture); }

  bool has_texture(const detail::FaceD& face) const {
    return has_vertex_texture() || ((attributes_ & wedge_texture) && is_textured(face));
  }

  void append(double value) { append_number(text_ += ' ', value); }

  void append_vertices() {
    number_.resize(mesh_.vert.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh_.vert.size(); ++i) {
      const auto& vertex = mesh_.vert[i];
      if (vertex.IsD()) continue;
      number_[i] = ++count;
      text_ += 'v';
      for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(vertex.cP()[k]));
      if (attributes_ & vertex_color)
        for (int k = 0; k < 3; ++k) append(vertex.cC()[k] / 255.0);
      text_ += '\n';
      if (!(attributes_ & vertex_normal)) continue;
      text_ += "vn";
      for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(vertex.cN()[k]));
      text_ += '\n';
    }
  }

  std::size_t texture_number(const detail::FaceD& face, int k) {
    const std::pair<float, float> place = has_vertex_texture() ? std::pair(face.cV(k)->cT().u(), face.cV(k)->cT().v())
                                                               : std::pair(face.cWT(k).u(), face.cWT(k).v());
    const auto [entry, is_new] = textures_.try_emplace(place, textures_.size() + 1);
    if (is_new) {
      text_ += "vt";
      append(place.first);
      append(place.second);
      text_ += '\n';
    }
    return entry->second;
  }

  void append_polygon(const detail::FaceD& first_face, const std::uint32_t* first, const std::uint32_t* last) {
    const bool textured = has_texture(first_face), normals = attributes_ & vertex_normal;
    std::string line = "f";
    for (; first != last; ++first) {
      const detail::FaceD& face = mesh_.face[*first / 3];
      const int k = static_cast<int>(*first % 3);
      const std::string vertex = std::to_string(number_[vcg::tri::Index(mesh_, face.cV(k))]);
      line.append(" ").append(vertex);
      if (textured || normals) line += '/';
      if (textured) line += std::to_string(texture_number(face, k));
      if (normals) line.append("/").append(vertex);
    }
    text_.append(line).append("\n");
  }

  const MeshFile& file_;
  const std::vector<std::string>& texture_names_;
  const Mesh& mesh_;
  int attributes_;
  std::string text_;
  std::vector<std::size_t> number_;
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
ObjBytes bytes_of(const MeshFile& file, const std::vector<std::string>& textures, const std::string& material_name) {
  ObjText<Scalar> obj(file, textures);
  std::string mesh = obj.text(material_name);
  return {std::move(mesh), material_text(obj.materials)};
}

}  // namespace

ObjBytes obj_bytes(const MeshFile& file, const std::vector<std::string>& textures, const std::string& material_name) {
  return file.precision == Precision::double_precision ? bytes_of<double>(file, textures, material_name)
                                                       : bytes_of<float>(file, textures, material_name);
}

}  // namespace mesh_tools::io
