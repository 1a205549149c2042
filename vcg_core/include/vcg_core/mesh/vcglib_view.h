// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstddef>
#include <type_traits>

#include <vcg/complex/complex.h>

#include <vcg_core/mesh/mesh_view.h>

namespace vcg_core {

namespace detail {

/// Bytes from one vertex's component to the next one's. vcglib keeps a component in the vertex, or in an array of its
/// own beside the vertices ("ocf"); either way at equal distances.
template <class Vertices, class Component>
std::ptrdiff_t stride_of(Vertices& vertices, const Component& component) {
  if (vertices.size() < 2) return 0;
  return reinterpret_cast<const char*>(&component(vertices[1])) -
         reinterpret_cast<const char*>(&component(vertices[0]));
}

template <class Element>
FlagRows flags_of(Element& first, int mask) {
  if (!Element::HasFlags()) return {};
  return {&first.Flags(), sizeof(Element), static_cast<std::uint32_t>(mask), sizeof(first.Flags())};
}

template <class Mesh>
void view_vertices(Mesh& mesh, MeshView& view) {
  using Vertex = typename Mesh::VertexType;
  Vertex& first = mesh.vert[0];
  view.positions = real_rows(first.P().V(), sizeof(Vertex));
  view.selected_vertices = flags_of(first, Vertex::SELECTED);
  view.deleted_vertices = flags_of(first, Vertex::DELETED);
  if (vcg::tri::HasPerVertexColor(mesh)) {
    const auto color = [](Vertex & vertex) -> auto& { return vertex.C(); };
    view.colors = {color(first).V(), stride_of(mesh.vert, color)};
  }
  if constexpr (std::is_same_v<typename Vertex::QualityType, float> ||
                std::is_same_v<typename Vertex::QualityType, double>) {
    const auto quality = [](Vertex & vertex) -> auto& { return vertex.Q(); };
    if (vcg::tri::HasPerVertexQuality(mesh)) view.scalars = real_rows(&quality(first), stride_of(mesh.vert, quality));
  }
}

template <class Mesh>
void view_faces(Mesh& mesh, MeshView& view) {
  using Face = typename Mesh::FaceType;
  Face& first = mesh.face[0];
  assert(&first.V(1) == &first.V(0) + 1 && &first.V(2) == &first.V(0) + 2);
  view.triangles = {&first.V(0), sizeof(Face), IndexType::address, mesh.vert.data(), sizeof(typename Mesh::VertexType)};
  view.selected_faces = flags_of(first, Face::SELECTED);
  view.deleted_faces = flags_of(first, Face::DELETED);
}

}  // namespace detail

/// Any vcglib triangle mesh, float or double, as the library sees it: no copy is made. Elements that vcglib has marked
/// as deleted are passed over; vertex indices are those into mesh.vert. Colour and quality are there if the mesh has
/// them, the latter if it is a float or a double.
template <class Mesh>
MeshView view_of(Mesh& mesh) {
  auto& writable = const_cast<std::remove_const_t<Mesh>&>(mesh);  // see MeshView
  MeshView view;
  view.vertices = mesh.vert.size();
  view.faces = mesh.face.size();
  if (view.vertices > 0) detail::view_vertices(writable, view);
  if (view.faces > 0) detail::view_faces(writable, view);
  return view;
}

}  // namespace vcg_core
