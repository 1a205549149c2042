// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>

#include <Eigen/Core>

#include <vcg_core/mesh/mesh_view.h>

#include "array.h"

namespace vcg_core::detail {

class Job;

using Vec3 = Eigen::Vector3d;
using Index = std::uint32_t;

/// A mesh as it was read: vertices that are not deleted, faces as indices into them. After welding, a vertex here is
/// all of the caller's vertices at one place: its copies.
struct RawMesh {
  Array<Vec3> position;
  Array<std::array<Index, 3>> face;
  Array<Index> host_vertex;      ///< the caller's index of each copy; those of a vertex side by side
  Array<Index> copy_begin;       ///< n + 1 offsets into host_vertex; empty if each vertex has one copy
  Array<std::uint8_t> selected;  ///< whether a copy of the vertex, or a face of it, is selected; empty: none is
  Array<std::array<Index, 2>> crease_ends;  ///< the vertices of the caller's creases, until they are found as edges
  Array<double> weight;                     ///< how far the vertex follows the filter, from 0 to 1; empty: all 1
  std::optional<WholeMesh> whole;           ///< as MeshView has it, but in units of the positions
  Array<Index> counted_copies;              ///< how many of a vertex's copies count; empty: all do
  Array<std::uint8_t> counted_face;         ///< whether a face counts; empty: all do
  std::size_t host_vertex_count = 0;        ///< how many vertices the caller has, deleted ones included
  /// The positions are the caller's times 2^exponent: so that no square over- or underflows, whatever the mesh's scale.
  /// A power of two, so that nothing is lost; 0 for meshes of a usual scale.
  int exponent = 0;
  double coordinate_epsilon = 0;  ///< of the caller's coordinates: the gap between 1 and the next larger number

  std::size_t first_copy(std::size_t v) const { return copy_begin.empty() ? v : copy_begin[v]; }
  std::size_t copies(std::size_t v) const { return first_copy(v + 1) - first_copy(v); }
  bool is_selected(std::size_t v) const { return !selected.empty() && selected[v] != 0; }
  /// What a vertex adds to the figures of a report; copies() but in a piece of a larger mesh.
  std::size_t counted(std::size_t v) const { return counted_copies.empty() ? copies(v) : counted_copies[v]; }
  std::size_t counted_vertices() const {
    return counted_copies.empty() ? host_vertex.size()
                                  : std::accumulate(counted_copies.begin(), counted_copies.end(), std::size_t{0});
  }
  std::size_t counted_faces() const {
    return counted_face.empty() ? face.size()
                                : static_cast<std::size_t>(std::count(counted_face.begin(), counted_face.end(), 1));
  }
  bool counts_face(std::size_t f) const { return counted_face.empty() || counted_face[f] != 0; }
};

/// Faces around each vertex, and what they tell of the vertex. A corner is 3 * face + (0, 1 or 2).
struct MeshTopology {
  Array<Index> star_begin;  ///< n + 1 offsets into star
  Array<Index> star;        ///< the corners at each vertex, ascending; faces with a repeated vertex left out
  Array<std::uint8_t> border;

  double average_edge_length = 0;   ///< |e|, in units of RawMesh::position: over unique edges, or that of the whole
  double own_edge_length = 0;       ///< the mean over the edges that count: those whose first vertex does
  std::size_t edges = 0;            ///< that count
  std::size_t border_vertices = 0;  ///< copies of vertices that count, as the next
  std::size_t non_manifold_vertices = 0;
  std::size_t degenerate_faces = 0;

  Array<std::uint8_t> crease;     ///< whether the edge opposite to each corner is a crease; empty if none is
  Array<std::uint8_t> on_crease;  ///< whether each vertex is on one; empty if none is
  std::size_t crease_edges = 0;

  bool is_on_crease(std::size_t v) const { return !on_crease.empty() && on_crease[v] != 0; }
};

/// All that the algorithms know of a mesh. Vertices and faces are in an order of the library's own, close in memory
/// when they are close in space.
struct MeshArrays : RawMesh {
  MeshTopology topology;
  std::size_t coincident_vertices = 0;  ///< copies of vertices that have more than one
  /// Place in host_vertex of the copy at each corner; kept on request, and where vertices have several copies.
  Array<std::array<Index, 3>> corner_copy;

  std::size_t size() const { return position.size(); }
};

inline Index next_in_face(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
inline Index previous_in_face(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
inline Index vertex_of(const MeshArrays& mesh, Index corner) { return mesh.face[corner / 3][corner % 3]; }
inline Index copy_of(const MeshArrays& mesh, Index corner) {
  return mesh.corner_copy.empty() ? vertex_of(mesh, corner) : mesh.corner_copy[corner / 3][corner % 3];
}

/// Most vertices, and most faces, of a mesh: 3 * face + (0, 1 or 2) has to be an Index, and not the largest one, which
/// means none.
constexpr std::size_t most_elements = (std::size_t(1) << 32) / 3;

/// Throws InvalidMesh if a mesh of this size has too many vertices or faces.
void require_countable(std::size_t vertices, std::size_t faces);

struct ReadOptions {
  double weld_distance = 0;    ///< as SmoothingLimits has it
  bool corner_copies = false;  ///< whether MeshArrays::corner_copy is asked for
};

/// Brings a mesh into the library's order, makes one of vertices at the same place, and finds the topology. Throws
/// InvalidMesh if no edge has a length.
/// @param raw      one copy for each vertex
/// @param options  weld_distance in units of `raw.position`
MeshArrays make_mesh_arrays(RawMesh raw, Job& job, const ReadOptions& options = {});

/// Index in `mesh` of each vertex of the caller's; `mesh.size()` for deleted ones.
Array<Index> vertex_of_host(const MeshArrays& mesh);

}  // namespace vcg_core::detail
