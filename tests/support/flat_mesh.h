// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <vcg/complex/complex.h>

namespace test_support {

using Point = vcg::Point3d;
using Triangle = std::array<std::size_t, 3>;

/// A triangle mesh as plain as can be: what tests build, change and compare.
struct FlatMesh {
  std::vector<Point> points;
  std::vector<Triangle> faces;
};

/// Every point replaced by what `change` makes of it.
FlatMesh transformed(FlatMesh mesh, const std::function<Point(const Point&)>& change);

/// Adds the vertices and faces of `other` behind those of `mesh`.
void append(FlatMesh& mesh, const FlatMesh& other);

/// For each vertex the first one at exactly its place.
std::vector<std::size_t> first_in_place(const FlatMesh& mesh);

/// The same mesh with faces that refer to the first vertex in each place only: what the library takes it for. The other
/// vertices stay, without faces.
FlatMesh welded(FlatMesh mesh);

/// Mean length of the unique edges, |e|. Faces with a repeated vertex are no triangles and are passed over.
double average_edge_length(const FlatMesh& mesh);

/// Copies a vcglib mesh; deleted elements are left out.
template <class Mesh>
FlatMesh flat(const Mesh& mesh) {
  FlatMesh result;
  std::vector<std::size_t> index(mesh.vert.size());
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    index[v] = result.points.size();
    if (mesh.vert[v].IsD()) continue;
    const auto p = mesh.vert[v].cP();
    result.points.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    const auto at = [&](int k) { return index[static_cast<std::size_t>(face.cV(k) - mesh.vert.data())]; };
    result.faces.push_back({at(0), at(1), at(2)});
  }
  return result;
}

/// Fills an empty vcglib mesh. (vcglib's meshes cannot be copied or moved.)
template <class Mesh>
void fill(Mesh& mesh, const FlatMesh& from) {
  using Scalar = typename Mesh::ScalarType;
  vcg::tri::Allocator<Mesh>::AddVertices(mesh, from.points.size());
  for (std::size_t v = 0; v < from.points.size(); ++v) {
    const Point& p = from.points[v];
    mesh.vert[v].P() =
        typename Mesh::CoordType(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]), static_cast<Scalar>(p[2]));
  }
  vcg::tri::Allocator<Mesh>::AddFaces(mesh, from.faces.size());
  for (std::size_t f = 0; f < from.faces.size(); ++f)
    for (int k = 0; k < 3; ++k) mesh.face[f].V(k) = &mesh.vert[from.faces[f][k]];
}

}  // namespace test_support
