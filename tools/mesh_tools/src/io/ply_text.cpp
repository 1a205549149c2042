// SPDX-License-Identifier: GPL-3.0-or-later
// Writes PLY: binary, little-endian.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

#include "formats.h"
#include "polygons.h"

namespace mesh_tools::io {
namespace {

/// Writes as vcglib's exporter does, by the same names and types. That one is not used, for in double precision it
/// writes texture coordinates of vertices in another type than it declares.
/// Scalar is the type of positions, normals and qualities.
template <class Scalar>
class PlyText {
 public:
  PlyText(const FlatFile& file, const std::vector<std::string>& textures)
      : file_(file),
        textures_(textures),
        mesh_(file.mesh),
        attributes_(file.attributes),
        count_(count_polygons(file)) {}

  std::string bytes() {
    append_header();
    bytes_.reserve(bytes_.size() + size_of_vertices() + size_of_triangles());
    for (std::size_t v = 0; v < mesh_.vertices(); ++v) append_vertex(v);
    visit_polygons(file_, [&](std::size_t face, const std::uint32_t* first, const std::uint32_t* last) {
      append_polygon(face, first, last);
    });
    if (has(edges))
      for (const auto& edge : mesh_.edge)
        for (const std::uint32_t end : edge) append(static_cast<std::int32_t>(end));
    return std::move(bytes_);
  }

 private:
  static constexpr const char* scalar = std::is_same_v<Scalar, float> ? "float" : "double";

  bool has(int attribute) const { return (attributes_ & attribute) != 0; }
  bool has_pages() const { return has(wedge_texture) && textures_.size() > 1; }
  /// Of texture coordinates there are two for each corner.
  bool has_long_lists() const { return 2 * count_.most_corners > 255; }

  /// Without attributes: room for most of what comes.
  std::size_t size_of_vertices() const { return mesh_.vertices() * 3 * sizeof(Scalar); }
  std::size_t size_of_triangles() const { return mesh_.face.size() * (1 + 3 * sizeof(std::int32_t)); }

  void declare(const std::string& type, std::initializer_list<const char*> names) {
    for (const char* name : names) bytes_ += "property " + type + " " + name + "\n";
  }

  void append_header() {
    bytes_ = "ply\nformat binary_little_endian 1.0\n";
    if (has(vertex_texture | wedge_texture))
      for (const std::string& texture : textures_) bytes_ += "comment TextureFile " + texture + "\n";
    bytes_ += "element vertex " + std::to_string(mesh_.vertices()) + "\n";
    declare(scalar, {"x", "y", "z"});
    if (has(vertex_normal)) declare(scalar, {"nx", "ny", "nz"});
    if (has(vertex_flags)) declare("int", {"flags"});
    if (has(vertex_color)) declare("uchar", {"red", "green", "blue", "alpha"});
    if (has(vertex_quality)) declare(scalar, {"quality"});
    if (has(vertex_radius)) declare("float", {"radius"});
    if (has(vertex_texture)) declare("float", {"texture_u", "texture_v"});
    bytes_ += "element face " + std::to_string(count_.count) + "\n";
    const std::string list = has_long_lists() ? "list int " : "list uchar ";
    declare(list + "int", {"vertex_indices"});
    if (has(face_flags)) declare("int", {"flags"});
    if (has(wedge_texture)) declare(list + "float", {"texcoord"});
    if (has_pages()) declare("int", {"texnumber"});
    if (has(face_color)) declare("uchar", {"red", "green", "blue", "alpha"});
    if (has(face_normal)) declare(scalar, {"nx", "ny", "nz"});
    if (has(face_quality)) declare(scalar, {"quality"});
    if (has(edges)) {
      bytes_ += "element edge " + std::to_string(mesh_.edge.size()) + "\n";
      declare("int", {"vertex1", "vertex2"});
    }
    bytes_ += "end_header\n";
  }

  template <class Value>
  void append(Value value) {
    append_binary(bytes_, value);
  }

  void append_point(const vcg::Point3d& p) {
    for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(p[k]));
  }

  void append_color(const vcg::Color4b& color) {
    for (int k = 0; k < 4; ++k) append(color[k]);
  }

  void append_vertex(std::size_t v) {
    append_point(mesh_.position[v]);
    if (has(vertex_normal)) append_point(mesh_.vertex_normal[v]);
    if (has(vertex_flags)) append(mesh_.vertex_flags[v]);
    if (has(vertex_color)) append_color(mesh_.vertex_color[v]);
    if (has(vertex_quality)) append(static_cast<Scalar>(mesh_.vertex_quality[v]));
    if (has(vertex_radius)) append(mesh_.vertex_radius[v]);
    if (has(vertex_texture)) append_place(mesh_.vertex_texture[v]);
  }

  void append_place(const FlatMesh::TextureCoordinate& place) {
    append(place.u);
    append(place.v);
  }

  void append_length(std::size_t length) {
    if (has_long_lists())
      append(static_cast<std::int32_t>(length));
    else
      append(static_cast<unsigned char>(length));
  }

  void append_polygon(std::size_t face, const std::uint32_t* first, const std::uint32_t* last) {
    const auto corners = static_cast<std::size_t>(last - first);
    append_length(corners);
    for (const std::uint32_t* corner = first; corner != last; ++corner)
      append(static_cast<std::int32_t>(mesh_.face[*corner / 3][*corner % 3]));
    if (has(face_flags)) append(mesh_.face_flags[face]);
    if (has(wedge_texture)) {
      const bool textured = is_textured(mesh_, face);
      append_length(textured ? 2 * corners : 0);
      for (const std::uint32_t* corner = first; corner != last && textured; ++corner)
        append_place(mesh_.wedge_texture[*corner / 3][*corner % 3]);
    }
    if (has_pages()) append(static_cast<std::int32_t>(mesh_.face_page.empty() ? 0 : mesh_.face_page[face]));
    if (has(face_color)) append_color(mesh_.face_color[face]);
    if (has(face_normal)) append_point(mesh_.face_normal[face]);
    if (has(face_quality)) append(static_cast<Scalar>(mesh_.face_quality[face]));
  }

  const FlatFile& file_;
  const std::vector<std::string>& textures_;
  const FlatMesh& mesh_;
  int attributes_;
  PolygonCount count_;
  std::string bytes_;
};

}  // namespace

std::string ply_bytes(const FlatFile& file, const std::vector<std::string>& textures) {
  return file.precision == Precision::double_precision ? PlyText<double>(file, textures).bytes()
                                                       : PlyText<float>(file, textures).bytes();
}

}  // namespace mesh_tools::io
