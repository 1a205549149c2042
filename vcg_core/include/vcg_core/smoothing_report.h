#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vcg_core {

/// Vertices that were free to move and yet could not be smoothed, by reason.
struct SkippedVertices {
  std::size_t isolated = 0;          ///< belongs to no face
  std::size_t undefined_normal = 0;  ///< all its faces have no area, or their normals cancel each other
  /// nothing within the cut-off distance to be smoothed by; only where predictions come from other elements than
  /// vertices
  std::size_t empty_neighbourhood = 0;

  std::size_t total() const { return isolated + undefined_normal + empty_neighbourhood; }
};

/// What a smoothing filter did. Lengths and volumes are in the mesh's own unit.
struct SmoothingReport {
  double average_edge_length = 0;  ///< |e|: mean length of the unique edges
  double sigma_c_length = 0;       ///< sigma_c |e|; this and the next two are 0 where a method has no such parameter
  double sigma_s_length = 0;       ///< sigma_s |e|
  double rho_length = 0;           ///< rho sigma_c |e|: the cut-off distance

  std::size_t vertices = 0;        ///< vertices of the mesh that are not deleted
  std::size_t moved_vertices = 0;  ///< vertices whose stored coordinates changed
  std::size_t fixed_vertices = 0;  ///< vertices held by `boundary` or `selected_only`
  SkippedVertices skipped_vertices;

  double max_displacement = 0;  ///< over the moved vertices
  double rms_displacement = 0;  ///< over the moved vertices
  /// Signed volume enclosed by the faces; for a mesh with borders, of the cone over it from the centre of its box.
  double volume_before = 0;
  double volume_after = 0;

  std::size_t border_vertices = 0;        ///< on an edge with one face
  std::size_t non_manifold_vertices = 0;  ///< on an edge with three or more faces
  std::size_t coincident_vertices = 0;    ///< at exactly the place of another vertex
  std::size_t degenerate_faces = 0;       ///< with a repeated vertex or without area

  /// Sentences for the user about what in the mesh limits the result, and the remedy; empty for a clean mesh.
  std::vector<std::string> warnings() const;
};

}  // namespace vcg_core
