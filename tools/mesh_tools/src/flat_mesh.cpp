// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <mesh_tools/mesh_io.h>  // first: the headers of vcglib below need it

#include <vcg/complex/algorithms/update/bounding.h>

#include "io/formats.h"
#include "io/polygons.h"

namespace mesh_tools {
namespace {

void fill_vertex(const FlatMesh& from, std::size_t v, detail::VertexD& to) {
  to.P() = from.position[v];
  if (!from.vertex_normal.empty()) to.N() = from.vertex_normal[v];
  if (!from.vertex_color.empty()) to.C() = from.vertex_color[v];
  if (!from.vertex_quality.empty()) to.Q() = from.vertex_quality[v];
  if (!from.vertex_flags.empty()) to.Flags() = from.vertex_flags[v];
  if (!from.vertex_radius.empty()) to.R() = from.vertex_radius[v];
  if (from.vertex_texture.empty()) return;
  to.T().u() = from.vertex_texture[v].u;
  to.T().v() = from.vertex_texture[v].v;
}

void fill_face(const FlatMesh& from, std::size_t f, Mesh& mesh) {
  detail::FaceD& to = mesh.face[f];
  for (int k = 0; k < 3; ++k) {
    const auto corner = static_cast<std::size_t>(k);
    to.V(k) = &mesh.vert[from.face[f][corner]];
    const FlatMesh::TextureCoordinate place =
        from.wedge_texture.empty() ? FlatMesh::TextureCoordinate() : from.wedge_texture[f][corner];
    to.WT(k).u() = place.u;
    to.WT(k).v() = place.v;
    to.WT(k).n() = from.face_page.empty() ? short(0) : from.face_page[f];
  }
  if (!from.face_normal.empty()) to.N() = from.face_normal[f];
  if (!from.face_color.empty()) to.C() = from.face_color[f];
  if (!from.face_quality.empty()) to.Q() = from.face_quality[f];
  if (!from.face_flags.empty()) to.Flags() = from.face_flags[f];
}

void fill(const FlatMesh& from, Mesh& mesh) {
  if (from.vertices() > 0) vcg::tri::Allocator<Mesh>::AddVertices(mesh, from.vertices());
  for (std::size_t v = 0; v < from.vertices(); ++v) fill_vertex(from, v, mesh.vert[v]);
  mesh.face.resize(from.face.size());
  mesh.fn = static_cast<int>(from.face.size());
  for (std::size_t f = 0; f < from.face.size(); ++f) fill_face(from, f, mesh);
  mesh.edge.resize(from.edge.size());
  mesh.en = static_cast<int>(from.edge.size());
  for (std::size_t e = 0; e < from.edge.size(); ++e)
    for (int k = 0; k < 2; ++k) mesh.edge[e].V(k) = &mesh.vert[from.edge[e][static_cast<std::size_t>(k)]];
  mesh.textures = from.textures;
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
}

/// Copies what a file of these attributes holds, but for deleted elements.
class Flattener {
 public:
  Flattener(const MeshFile& file, FlatFile& flat) : from_(file.mesh), attributes_(file.attributes), to_(flat.mesh) {
    flat.precision = file.precision;
  }

  void run(const MeshFile& file, Polygons& polygons) {
    add_vertices();
    io::visit_polygons(file, [&](std::size_t face, const std::uint32_t* first, const std::uint32_t* last) {
      add_polygon(face, first, last, polygons);
    });
    for (const auto& edge : from_.edge)
      if (!edge.IsD()) to_.edge.push_back({number_of(edge.cV(0)), number_of(edge.cV(1))});
    to_.textures = from_.textures;
  }

 private:
  bool has(int attribute) const { return (attributes_ & attribute) != 0; }
  std::uint32_t number_of(const detail::VertexD* vertex) const { return number_[vcg::tri::Index(from_, vertex)]; }

  void add_vertices() {
    number_.resize(from_.vert.size());
    to_.position.reserve(from_.vert.size());
    for (std::size_t v = 0; v < from_.vert.size(); ++v) {
      const detail::VertexD& vertex = from_.vert[v];
      if (vertex.IsD()) continue;
      number_[v] = static_cast<std::uint32_t>(to_.position.size());
      to_.position.push_back(vertex.cP());
      if (has(io::vertex_normal)) to_.vertex_normal.push_back(vertex.cN());
      if (has(io::vertex_color)) to_.vertex_color.push_back(vertex.cC());
      if (has(io::vertex_quality)) to_.vertex_quality.push_back(vertex.cQ());
      if (has(io::vertex_flags)) to_.vertex_flags.push_back(vertex.cFlags());
      if (has(io::vertex_radius)) to_.vertex_radius.push_back(static_cast<float>(vertex.cR()));
      if (has(io::vertex_texture)) to_.vertex_texture.push_back({vertex.cT().u(), vertex.cT().v()});
    }
  }

  /// The triangles of a polygon, deleted or not, stay together.
  void add_polygon(std::size_t first_face, const std::uint32_t* first, const std::uint32_t* last, Polygons& polygons) {
    const auto corners = static_cast<std::size_t>(last - first);
    const auto moved = static_cast<std::uint32_t>(3 * (to_.face.size() - first_face));  // modulo 2^32
    if (corners > 3) {
      polygons.polygons.push_back(
          {static_cast<std::uint32_t>(to_.face.size()), static_cast<std::uint32_t>(polygons.corners.size())});
      for (; first != last; ++first) polygons.corners.push_back(*first + moved);
    }
    for (std::size_t f = first_face; f < first_face + corners - 2; ++f) add_face(from_.face[f]);
  }

  void add_face(const detail::FaceD& face) {
    to_.face.push_back({number_of(face.cV(0)), number_of(face.cV(1)), number_of(face.cV(2))});
    if (has(io::face_normal)) to_.face_normal.push_back(face.cN());
    if (has(io::face_color)) to_.face_color.push_back(face.cC());
    if (has(io::face_quality)) to_.face_quality.push_back(face.cQ());
    if (has(io::face_flags)) to_.face_flags.push_back(face.cFlags());
    if (has(io::wedge_texture)) {
      auto& wedge = to_.wedge_texture.emplace_back();
      for (int k = 0; k < 3; ++k) wedge[static_cast<std::size_t>(k)] = {face.cWT(k).u(), face.cWT(k).v()};
      to_.face_page.push_back(face.cWT(0).n());
    }
  }

  const Mesh& from_;
  int attributes_;
  FlatMesh& to_;
  std::vector<std::uint32_t> number_;  // of the vertices that are not deleted
};

}  // namespace

FlatFile to_flat(const MeshFile& file) {
  FlatFile flat;
  static_cast<FileFacts&>(flat) = file;
  flat.polygons = {};
  Flattener(file, flat).run(file, flat.polygons);
  return flat;
}

MeshFile to_vcglib(FlatFile flat) {
  MeshFile file;
  fill(flat.mesh, file.mesh);
  flat.mesh = {};
  static_cast<FileFacts&>(file) = std::move(flat);
  return file;
}

void update_normals(FlatMesh& mesh) {
  Mesh copy;
  fill(mesh, copy);
  update_normals(copy);
  if (!mesh.vertex_normal.empty())
    for (std::size_t v = 0; v < mesh.vertices(); ++v) mesh.vertex_normal.set(v, copy.vert[v].cN());
  if (!mesh.face_normal.empty())
    for (std::size_t f = 0; f < mesh.face.size(); ++f) mesh.face_normal.set(f, copy.face[f].cN());
  for (std::size_t v = 0; v < mesh.vertex_flags.size(); ++v) mesh.vertex_flags[v] = copy.vert[v].cFlags();
}

}  // namespace mesh_tools
