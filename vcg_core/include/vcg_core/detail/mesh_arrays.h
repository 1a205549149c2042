#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include <vcg_core/detail/array.h>

namespace vcg_core::detail {

class Job;

using Vec3 = Eigen::Vector3d;
using Index = std::uint32_t;

/// A mesh as it was read: vertices that are not deleted, faces as indices into them.
struct RawMesh {
  Array<Vec3> position;
  Array<std::array<Index, 3>> face;
  Array<Index> host_vertex;           ///< index of each vertex in the caller's mesh.vert
  Array<std::uint8_t> selected;       ///< whether the vertex, or a face of it, is selected
  std::size_t host_vertex_count = 0;  ///< size of the caller's mesh.vert, deleted ones included
  /// The positions are the caller's times 2^exponent, with the largest coordinate in [1, 2). A power of two, so that
  /// nothing is lost, wherever the mesh lies; and no square over- or underflows, whatever its scale.
  int exponent = 0;
  double coordinate_epsilon = 0;  ///< of the caller's coordinates: the gap between 1 and the next larger number
};

/// Faces around each vertex, and what they tell of the vertex. A corner is 3 * face + (0, 1 or 2).
struct MeshTopology {
  Array<Index> star_begin;  ///< n + 1 offsets into star
  Array<Index> star;        ///< the corners at each vertex, ascending; faces with a repeated vertex left out
  Array<std::uint8_t> border;

  double average_edge_length = 0;  ///< |e| over unique edges, in units of RawMesh::position
  std::size_t border_vertices = 0;
  std::size_t non_manifold_vertices = 0;
  std::size_t degenerate_faces = 0;
};

/// All that the algorithms know of a mesh. Vertices and faces are in an order of the library's own, close in memory
/// when they are close in space.
struct MeshArrays : RawMesh {
  MeshTopology topology;
  std::size_t coincident_vertices = 0;

  std::size_t size() const { return position.size(); }
};

inline Index next_in_face(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
inline Index previous_in_face(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
inline Index vertex_of(const MeshArrays& mesh, Index corner) { return mesh.face[corner / 3][corner % 3]; }

/// Most vertices, and most faces, of a mesh: 3 * face + (0, 1 or 2) has to be an Index, and not the largest one, which
/// means none.
constexpr std::size_t most_elements = (std::size_t(1) << 32) / 3;

/// Throws InvalidMesh if a mesh of this size has too many vertices or faces.
void require_countable(std::size_t vertices, std::size_t faces);

/// Brings a mesh into the library's order and finds its topology. Throws InvalidMesh if no edge has a length.
MeshArrays make_mesh_arrays(RawMesh raw, Job& job);

/// Index in `mesh` of each vertex of the caller's mesh.vert; `mesh.size()` for deleted ones.
Array<Index> vertex_of_host(const MeshArrays& mesh);

}  // namespace vcg_core::detail
