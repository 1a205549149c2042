// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/creases.h"
#include "mesh_arrays.h"
#include "sparse_index_map.h"

namespace vcg_core::detail {

constexpr Index no_face = static_cast<Index>(-1);

/// The face across each edge, by corner: the edge opposite to the corner. `no_face` at borders, at edges with three
/// or more faces and at creases.
Array<Index> faces_across(const MeshArrays& mesh, Job& job);

inline std::size_t faces_of(const MeshTopology& topology, Index v) {
  return topology.star_begin[v + 1] - topology.star_begin[v];
}

/// A vertex with more faces than this, say the tip of a finely cut cone, would make lists of quadratic length.
constexpr std::size_t many_faces = 48;

/// The faces around a face: itself and all that share a vertex with it and lie on the same side of the creases there;
/// at vertices with very many faces only those across an edge, so that there are not too many. Some more than once.
/// @param on_face    called with single faces, itself first
/// @param on_vertex  called with vertices all of whose faces are around it
template <class OnFace, class OnVertex>
void visit_faces_around(const MeshArrays& mesh, const Array<Index>& across, Index f, const OnFace& on_face,
                        const OnVertex& on_vertex) {
  on_face(f);
  bool has_all_across = true;  // as faces of its vertices
  for (Index corner = 3 * f; corner < 3 * f + 3; ++corner) {
    const Index v = vertex_of(mesh, corner);
    const bool has_few = faces_of(mesh.topology, v) <= many_faces;
    if (has_few && !mesh.topology.is_on_crease(v)) {
      on_vertex(v);
      continue;
    }
    has_all_across = false;
    if (!has_few) continue;
    Array<Index> sector;
    add_faces_of_sector(mesh, v, corner, sector);
    for (const Index g : sector) on_face(g);
  }
  if (has_all_across) return;
  for (Index corner = 3 * f; corner < 3 * f + 3; ++corner)
    if (across[corner] != no_face) on_face(across[corner]);
}

/// Calls visit(g) for the faces of a vertex.
template <class Visit>
void visit_faces_of(const MeshTopology& topology, Index v, const Visit& visit) {
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) visit(topology.star[s] / 3);
}

/// Faces or vertices that were seen from the current face.
class Marks {
 public:
  explicit Marks(std::size_t size) : seen_from_(size) {}
  void begin(Index current) { current_ = current; }
  /// Keeps the memory small: to be called now and then.
  void forget_all() { seen_from_.clear(); }
  bool has(Index i) const { return seen_from_[i] == current_; }
  /// Whether it was not marked before.
  bool add(Index i) { return seen_from_.exchange(i, current_) != current_; }

 private:
  SparseIndexMap seen_from_;
  Index current_ = 0;
};

/// Finds the faces around one face after the other, each once. Lists of those of all faces would be a hundred bytes a
/// vertex. Each thread has one of its own.
class FacesAround {
 public:
  /// Refers to both.
  FacesAround(const MeshArrays& mesh, const Array<Index>& across);

  /// Itself first; valid until the next call.
  const Array<Index>& find(Index f);
  /// Whether the last call found it.
  bool found(Index g) const { return marks_.has(g); }
  /// To be called now and then, like Marks::forget_all().
  void forget_all() { marks_.forget_all(); }

 private:
  const MeshArrays& mesh_;
  const Array<Index>& across_;
  Marks marks_;
  Array<Index> list_;
};

}  // namespace vcg_core::detail
