// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include <vcg_core/mesh/guided_whole.h>

namespace vcg_core {

enum class RealType : std::uint8_t { float32, float64 };

enum class IndexType : std::uint8_t {
  int32,
  uint32,
  int64,
  uint64,
  address  ///< the address of the vertex's own record, as meshes of linked records have it: see IndexRows
};

/// Rows of floating-point numbers in the caller's memory. The numbers of a row lie side by side; rows may lie anywhere
/// at equal distances, aligned or not.
struct RealRows {
  void* data = nullptr;       ///< row 0; null: there are no rows
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next
  RealType type = RealType::float64;

  explicit operator bool() const { return data != nullptr; }
};

/// Rows of vertex indices, in the same way.
struct IndexRows {
  const void* data = nullptr;
  std::ptrdiff_t stride = 0;
  IndexType type = IndexType::uint32;
  const void* records = nullptr;  ///< of IndexType::address: the record of vertex 0
  std::size_t record_size = 0;    ///< of IndexType::address: bytes from one vertex's record to the next

  explicit operator bool() const { return data != nullptr; }
};

/// A mark for each vertex or face: it is set if any bit of `mask` is.
struct FlagRows {
  const void* data = nullptr;  ///< null: no mark is set
  std::ptrdiff_t stride = 1;
  std::uint32_t mask = (std::numeric_limits<std::uint32_t>::max)();
  std::size_t size = 1;  ///< bytes of a mark: 1 or 4

  explicit operator bool() const { return data != nullptr; }
};

/// Four bytes for each vertex: red, green, blue, alpha.
struct ColorRows {
  std::uint8_t* data = nullptr;
  std::ptrdiff_t stride = 4;

  explicit operator bool() const { return data != nullptr; }
};

/// What a piece of a larger mesh is told of the whole, so that its vertices come out as they do in the whole. Lengths
/// and coordinates in the mesh's unit.
struct WholeMesh {
  double box_min[3] = {0, 0, 0};  ///< of the smallest box around all vertices of the whole
  double box_max[3] = {0, 0, 0};
  double average_edge_length = 0;     ///< |e| of the whole; 0: not known, that of the piece is measured
  std::optional<GuidedWhole> guided;  ///< for the guided filter; empty: that of the piece is measured
};

/// A triangle mesh in the caller's memory, whichever library it belongs to: where its numbers are, no copy of them. It
/// owns nothing and must not outlive them. `smooth` writes through it; all other functions only read, so that a view of
/// constant memory, cast to look writable, is safe with them.
///
/// Vertices at exactly the same place are one vertex of the surface to every function: for connectivity, normals,
/// distances and movement. Meshes that are split along the seams of texture charts, or into single triangles as in STL
/// files, need no merging.
struct MeshView {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  RealRows positions;   ///< three numbers a vertex
  IndexRows triangles;  ///< three indices a face, below `vertices`

  // All of these may be missing.
  FlagRows selected_vertices;
  FlagRows selected_faces;
  FlagRows deleted_vertices;  ///< vertices and faces that are passed over
  FlagRows deleted_faces;
  /// How far each vertex follows the filter, from 0 (it stays, bit for bit) to 1. Each pass moves a vertex by its
  /// weight times what the filter would. Of vertices at the same place the smallest weight counts.
  RealRows weights;
  /// Edges of the shape, two vertex indices each. The guided filter keeps them sharp however flat they are: it looks at
  /// the faces on one side of a crease only, and the vertices on it go to where the sides meet. Other filters do not
  /// look at them.
  IndexRows creases;
  std::size_t crease_count = 0;
  /// For a piece of a larger mesh. The piece has to hold, besides the vertices of interest, all that these depend on:
  /// for the paper's filter the vertices within (rho sigma_c + 0.5) |e| of them, for the guided one those within 40 |e|
  /// (24 without its blend), and all faces of those. Farther out, where the piece ends, results are worth nothing.
  std::optional<WholeMesh> whole;
  /// The vertices and faces that are of interest. Others move as well, unless their weight is 0, but do not count: not
  /// in a report, a summary or a volume. Without these rows all count.
  FlagRows counted_vertices;
  FlagRows counted_faces;
  ColorRows colors;  ///< changed only where SmoothingParameters::smooth_color asks for it, as is the next
  RealRows scalars;  ///< one number a vertex, such as a quality; may be undefined (not a number)
};

/// Rows of `float` or `double`, one number or three each.
/// @param stride  bytes from one row to the next
inline RealRows real_rows(float* first, std::ptrdiff_t stride) { return {first, stride, RealType::float32}; }
inline RealRows real_rows(double* first, std::ptrdiff_t stride) { return {first, stride, RealType::float64}; }

/// Rows of integers of 32 or 64 bits, signed or not.
template <class Integer>
IndexRows index_rows(const Integer* first, std::ptrdiff_t stride) {
  static_assert(std::is_integral_v<Integer> && (sizeof(Integer) == 4 || sizeof(Integer) == 8));
  constexpr IndexType narrow = std::is_signed_v<Integer> ? IndexType::int32 : IndexType::uint32;
  constexpr IndexType wide = std::is_signed_v<Integer> ? IndexType::int64 : IndexType::uint64;
  return {first, stride, sizeof(Integer) == 4 ? narrow : wide, nullptr, 0};
}

/// A mesh of positions and faces without gaps: `positions` holds 3 * vertices numbers, `triangles` 3 * faces indices.
template <class Real, class Integer>
MeshView packed_mesh(Real* positions, std::size_t vertices, const Integer* triangles, std::size_t faces) {
  MeshView view;
  view.vertices = vertices;
  view.faces = faces;
  view.positions = real_rows(positions, 3 * sizeof(Real));
  view.triangles = index_rows(triangles, 3 * sizeof(Integer));
  return view;
}

}  // namespace vcg_core
