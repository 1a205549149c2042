// SPDX-License-Identifier: GPL-3.0-or-later
// Writes PLY: binary, little-endian.

#include <algorithm>
#include <cstdint>
#include <cstring>
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
  PlyText(const MeshFile& file, const std::vector<std::string>& textures)
      : file_(file),
        textures_(textures),
        mesh_(file.mesh),
        attributes_(file.attributes),
        count_(count_polygons(file)) {}

  std::string bytes() {
    append_header();
    std::vector<std::int32_t> number(mesh_.vert.size());
    std::int32_t count = 0;
    for (std::size_t i = 0; i < mesh_.vert.size(); ++i) {
      if (mesh_.vert[i].IsD()) continue;
      number[i] = count++;
      append_vertex(mesh_.vert[i]);
    }
    visit_polygons(file_, [&](std::size_t face, const std::uint32_t* first, const std::uint32_t* last) {
      append_polygon(mesh_.face[face], first, last, number);
    });
    for (const auto& edge : mesh_.edge)
      if (has(edges) && !edge.IsD())
        for (int k = 0; k < 2; ++k) append(number[vcg::tri::Index(mesh_, edge.cV(k))]);
    return std::move(bytes_);
  }

 private:
  static constexpr const char* scalar = std::is_same_v<Scalar, float> ? "float" : "double";

  bool has(int attribute) const { return (attributes_ & attribute) != 0; }
  bool has_pages() const { return has(wedge_texture) && textures_.size() > 1; }
  /// Of texture coordinates there are two for each corner.
  bool has_long_lists() const { return 2 * count_.most_corners > 255; }

  void declare(const std::string& type, std::initializer_list<const char*> names) {
    for (const char* name : names) bytes_ += "property " + type + " " + name + "\n";
  }

  void append_header() {
    bytes_ = "ply\nformat binary_little_endian 1.0\n";
    if (has(vertex_texture | wedge_texture))
      for (const std::string& texture : textures_) bytes_ += "comment TextureFile " + texture + "\n";
    bytes_ += "element vertex " + std::to_string(mesh_.vn) + "\n";
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
      bytes_ += "element edge " + std::to_string(mesh_.en) + "\n";
      declare("int", {"vertex1", "vertex2"});
    }
    bytes_ += "end_header\n";
  }

  template <class Value>
  void append(Value value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (is_big_endian_machine()) std::reverse(raw, raw + sizeof value);
    bytes_.append(raw, sizeof value);
  }

  template <class Point>
  void append_point(const Point& p) {
    for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(p[k]));
  }

  void append_color(const vcg::Color4b& color) {
    for (int k = 0; k < 4; ++k) append(color[k]);
  }

  void append_vertex(const detail::VertexD& vertex) {
    append_point(vertex.cP());
    if (has(vertex_normal)) append_point(vertex.cN());
    if (has(vertex_flags)) append(static_cast<std::int32_t>(vertex.cFlags()));
    if (has(vertex_color)) append_color(vertex.cC());
    if (has(vertex_quality)) append(static_cast<Scalar>(vertex.cQ()));
    if (has(vertex_radius)) append(static_cast<float>(vertex.cR()));
    if (has(vertex_texture)) {
      append(static_cast<float>(vertex.cT().u()));
      append(static_cast<float>(vertex.cT().v()));
    }
  }

  void append_length(std::size_t length) {
    if (has_long_lists())
      append(static_cast<std::int32_t>(length));
    else
      append(static_cast<unsigned char>(length));
  }

  void append_polygon(const detail::FaceD& face, const std::uint32_t* first, const std::uint32_t* last,
                      const std::vector<std::int32_t>& number) {
    const auto corners = static_cast<std::size_t>(last - first);
    append_length(corners);
    for (const std::uint32_t* corner = first; corner != last; ++corner)
      append(number[vcg::tri::Index(mesh_, mesh_.face[*corner / 3].cV(static_cast<int>(*corner % 3)))]);
    if (has(face_flags)) append(static_cast<std::int32_t>(face.cFlags()));
    if (has(wedge_texture)) {
      append_length(is_textured(face) ? 2 * corners : 0);
      for (const std::uint32_t* corner = first; corner != last && is_textured(face); ++corner) {
        const auto& place = mesh_.face[*corner / 3].cWT(static_cast<int>(*corner % 3));
        append(static_cast<float>(place.u()));
        append(static_cast<float>(place.v()));
      }
    }
    if (has_pages()) append(static_cast<std::int32_t>(face.cWT(0).n()));
    if (has(face_color)) append_color(face.cC());
    if (has(face_normal)) append_point(face.cN());
    if (has(face_quality)) append(static_cast<Scalar>(face.cQ()));
  }

  const MeshFile& file_;
  const std::vector<std::string>& textures_;
  const Mesh& mesh_;
  int attributes_;
  PolygonCount count_;
  std::string bytes_;
};

}  // namespace

std::string ply_bytes(const MeshFile& file, const std::vector<std::string>& textures) {
  return file.precision == Precision::double_precision ? PlyText<double>(file, textures).bytes()
                                                       : PlyText<float>(file, textures).bytes();
}

}  // namespace mesh_tools::io
