// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// A mesh as scanners, modellers and broken files make them, and what a filter has to say to it.
struct BadMesh {
  std::string name;
  FlatMesh mesh;  ///< an index of a face may be that of no vertex
  std::vector<std::size_t> deleted_vertices;
  std::vector<std::size_t> deleted_faces;
  std::string error;           ///< part of the message of InvalidMesh; empty: there is a result
  bool within_a_file = true;   ///< whether a file can hold it: no file has deleted elements or indices out of range
  bool has_figures = true;     ///< false where lengths or volumes leave the range of the numbers
  bool large_support = false;  ///< neighbourhoods are thousands of vertices: slow
};

/// The families, in an order that does not change. `smallest` and `largest` bound the numbers that the mesh's precision
/// can hold.
std::vector<BadMesh> bad_meshes(double smallest, double largest);

/// The families for vertices of that type.
template <class Scalar>
std::vector<BadMesh> bad_meshes() {
  return bad_meshes(std::numeric_limits<Scalar>::denorm_min(), std::numeric_limits<Scalar>::max());
}

/// Names of all families, the same for every precision.
std::vector<std::string> bad_mesh_names();

/// The family of that name.
template <class Scalar>
BadMesh bad_mesh(const std::string& name) {
  for (BadMesh& bad : bad_meshes<Scalar>())
    if (bad.name == name) return std::move(bad);
  return {};
}

/// Fills an empty vcglib mesh, with references as bad as they are.
template <class Mesh>
void fill(Mesh& mesh, const BadMesh& bad) {
  FlatMesh sound = bad.mesh;
  for (Triangle& f : sound.faces)
    for (std::size_t& v : f)
      if (v >= sound.points.size()) v = 0;
  fill(mesh, sound);
  for (std::size_t f = 0; f < bad.mesh.faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = bad.mesh.faces[f][k];
      if (v < bad.mesh.points.size()) continue;
      // By its address, as there is no such element.
      using Vertex = typename Mesh::VertexType;
      mesh.face[f].V(k) =
          reinterpret_cast<Vertex*>(reinterpret_cast<std::uintptr_t>(mesh.vert.data()) + v * sizeof(Vertex));
    }
  for (const std::size_t f : bad.deleted_faces) vcg::tri::Allocator<Mesh>::DeleteFace(mesh, mesh.face[f]);
  for (const std::size_t v : bad.deleted_vertices) vcg::tri::Allocator<Mesh>::DeleteVertex(mesh, mesh.vert[v]);
}

/// For GoogleTest's messages.
inline std::ostream& operator<<(std::ostream& out, const BadMesh& bad) { return out << bad.name; }

}  // namespace test_support
