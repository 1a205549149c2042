// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <vcg/complex/complex.h>

#include <vcg_core/method.h>

#include "byte_stream.h"

namespace fuzz {

/// A mesh, defects and all, and what to do with it: one input of the core's fuzzer.
struct CoreCase {
  struct Vertex {
    float x, y, z;
    std::uint8_t flags;
  };
  struct Face {
    std::uint8_t corner[3];  ///< one more than the last vertex: a reference to no vertex
    std::uint8_t flags;
  };
  static constexpr std::uint8_t deleted = 1, selected = 2;

  vcg_core::Method method = vcg_core::Method::paper;
  vcg_core::SmoothingParameters parameters;
  bool double_precision = false;
  std::uint8_t cancel_at = 0;  ///< the call of the progress callable that cancels; 0: none
  std::vector<Vertex> vertices;
  std::vector<Face> faces;

  static CoreCase decode(const std::uint8_t* data, std::size_t size);
  std::string encode() const;
};

/// Fills an empty mesh. References to no vertex point just behind the last one.
template <class Mesh>
void fill(Mesh& mesh, const CoreCase& from) {
  using Scalar = typename Mesh::ScalarType;
  if (!from.vertices.empty()) vcg::tri::Allocator<Mesh>::AddVertices(mesh, from.vertices.size());
  if (!from.faces.empty()) vcg::tri::Allocator<Mesh>::AddFaces(mesh, from.faces.size());
  for (std::size_t f = 0; f < from.faces.size(); ++f) {
    for (int k = 0; k < 3; ++k)
      mesh.face[f].V(k) = mesh.vert.data() + from.faces[f].corner[k] % (from.vertices.size() + 1);
    if (from.faces[f].flags & CoreCase::selected) mesh.face[f].SetS();
    if (from.faces[f].flags & CoreCase::deleted) vcg::tri::Allocator<Mesh>::DeleteFace(mesh, mesh.face[f]);
  }
  for (std::size_t v = 0; v < from.vertices.size(); ++v) {
    const CoreCase::Vertex& vertex = from.vertices[v];
    mesh.vert[v].P() = typename Mesh::CoordType(static_cast<Scalar>(vertex.x), static_cast<Scalar>(vertex.y),
                                                static_cast<Scalar>(vertex.z));
    if (vertex.flags & CoreCase::selected) mesh.vert[v].SetS();
    if (vertex.flags & CoreCase::deleted) vcg::tri::Allocator<Mesh>::DeleteVertex(mesh, mesh.vert[v]);
  }
}

}  // namespace fuzz
