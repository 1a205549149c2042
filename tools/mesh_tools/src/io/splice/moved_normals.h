// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <mesh_tools/flat_mesh.h>

namespace mesh_tools::io {

/// What the vertices of a file were, and which of them move.
struct MovedVertices {
  std::vector<vcg::Point3d> before;
  std::vector<bool> moved;  ///< whether the file gets another number

  /// Adds a vertex; both places as the file holds them.
  void add(const vcg::Point3d& before_place, const vcg::Point3d& now);
};

/// Makes the normals of a file anew in the structure that they have. A file holds a list of normals, and corners of
/// faces refer to them. Corners at one place whose normals were equal belong to one smooth piece of the surface,
/// whatever vertices and normals the file writes there; they get the mean of their faces' normals, weighted by their
/// angles. Where the normals were different there is an edge, and it stays one. A normal that corners at several places
/// share becomes the mean over all of them.
class MovedNormals {
 public:
  /// A corner of a face: its vertex, and which normal it refers to.
  struct Corner {
    std::uint32_t vertex, normal;
  };

  /// All are referred to, not copied.
  /// @param mesh     its vertices are where the file's vertices go
  /// @param normals  the list of the file's normals
  MovedNormals(const FlatMesh& mesh, const MovedVertices& vertices, const std::vector<vcg::Point3d>& normals);

  /// Takes a face into account: a polygon, given by corners around it, at least three, with indices in range.
  void add_face(const std::vector<Corner>& corners);

  /// Takes the mesh's triangles into account, where each vertex has the normal of its own index.
  void add_triangles();

  /// To be called when all faces are added.
  void finish();

  /// The new normal, of unit length; nothing if it stays: no vertex of a face that it follows from moves, or these
  /// faces have no direction.
  std::optional<vcg::Point3d> normal(std::size_t index) const;

 private:
  struct Piece {
    std::uint32_t place, value;
    bool moved = false;
    vcg::Point3d sum{0, 0, 0};
  };

  std::uint32_t piece_of(const Corner& corner);

  const FlatMesh& mesh_;
  const MovedVertices& vertices_;
  std::vector<std::uint32_t> place_, value_;  // equal ones have the same number
  std::vector<Piece> pieces_;
  std::unordered_map<std::uint64_t, std::uint32_t> piece_at_;    // by place and value
  std::vector<std::uint32_t> first_piece_;                       // of a normal
  std::vector<std::pair<std::uint32_t, std::uint32_t>> others_;  // normal and piece, of those with several
};

/// Normal of a polygon, of unit length; zero if it has none. By Newell's formula: of a polygon that is not plane the
/// normal of a plane through its middle.
/// @param vertices  indices into the mesh, in range
vcg::Point3d polygon_normal(const FlatMesh& mesh, const std::vector<std::uint32_t>& vertices);

}  // namespace mesh_tools::io
