// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "mesh_arrays.h"
#include "sparse_index_map.h"

namespace vcg_core::detail {

/// A list of faces for each face, itself first.
struct FaceLists {
  Array<std::size_t> begin;  ///< one more than faces
  Array<Index> face;

  const Index* first(std::size_t f) const { return face.data() + begin[f]; }
  const Index* last(std::size_t f) const { return face.data() + begin[f + 1]; }
};

constexpr Index no_face = static_cast<Index>(-1);

/// The face across each edge, by corner: the edge opposite to the corner. `no_face` at borders, at edges with three
/// or more faces and at creases.
Array<Index> faces_across(const MeshArrays& mesh, Job& job);

/// Faces that were seen from the current one.
class FaceMarks {
 public:
  explicit FaceMarks(std::size_t faces) : seen_from_(faces) {}
  void begin(Index current) { current_ = current; }
  /// Keeps the memory small: to be called now and then.
  void forget_all() { seen_from_.clear(); }
  /// Whether it was not marked before.
  bool add(Index f) {
    if (seen_from_[f] == current_) return false;
    seen_from_.set(f, current_);
    return true;
  }

 private:
  SparseIndexMap seen_from_;
  Index current_ = 0;
};

/// Finds the faces of faces_around(), for who needs them once: the lists of all are a hundred bytes a vertex. Each
/// thread has one of its own.
class FacesAround {
 public:
  /// Refers to both.
  FacesAround(const MeshArrays& mesh, const Array<Index>& across);

  /// Valid until the next call.
  const Array<Index>& find(Index f);
  void forget_all() { marks_.forget_all(); }

 private:
  const MeshArrays& mesh_;
  const Array<Index>& across_;
  FaceMarks marks_;
  Array<Index> list_;
};

/// For each face all faces that share a vertex with it and lie on the same side of the creases there; at vertices with
/// very many faces only those across an edge, so that the lists stay linear in the mesh.
FaceLists faces_around(const MeshArrays& mesh, const Array<Index>& across, Job& job);

/// Mean distance of adjoining centroids around each face: 0.6 times the mean edge length at its vertices, smoothed over
/// three rings, so that neighbourhoods follow the mesh where edges become shorter or longer.
/// @param least  in units of the positions: where edges are shorter, the spacing is this, or that of the average edge
///               if that is less
Array<double> local_spacing(const MeshArrays& mesh, bool follow_edge_length, double least, Job& job);

/// For each face those with a centroid closer than radius * spacing[f] that faces of this kind connect with it: a ball
/// that does not leak to a sheet that is near in space and far on the surface. At least the faces around it where that
/// gives fewer than four.
FaceLists faces_within(const FaceLists& around, const Array<Vec3>& centroid, const Array<double>& spacing,
                       double radius, Job& job);

}  // namespace vcg_core::detail
