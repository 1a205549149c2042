// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
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
  std::size_t fixed_vertices = 0;  ///< vertices held by `boundary`, `selected_only` or a weight of 0
  SkippedVertices skipped_vertices;

  double max_displacement = 0;  ///< over the moved vertices
  double rms_displacement = 0;  ///< over the moved vertices
  /// Signed volume enclosed by the faces; for a mesh with borders, of the cone over it from the centre of its box.
  double volume_before = 0;
  double volume_after = 0;

  std::size_t border_vertices = 0;        ///< on an edge with one face
  std::size_t non_manifold_vertices = 0;  ///< on an edge with three or more faces
  /// At exactly the place of another vertex, or within SmoothingLimits::weld_distance of it: they are one vertex of the
  /// surface and move as one. All counts of vertices count each of them.
  std::size_t coincident_vertices = 0;
  /// On a border, and near another vertex of a border: within 1e-5 of the diagonal of the mesh's box, and a tenth of
  /// its own shortest edge. Most are vertices that ought to be one, but for rounding.
  std::size_t nearly_coincident_vertices = 0;
  double nearly_coincident_distance = 0;  ///< the largest between two of those
  std::size_t degenerate_faces = 0;       ///< with a repeated vertex or without area
  std::size_t crease_edges = 0;           ///< edges of the mesh that are among MeshView::creases, each once

  std::size_t faces = 0;  ///< faces of the mesh that are not deleted
  /// Faces whose normal points to the other side than before (its product with the old one is negative). Faces without
  /// area before or after have no normal and do not count; a face without area is one whose height is less than 1e-12
  /// of its longest edge.
  std::size_t flipped_faces = 0;
  std::size_t far_moved_vertices = 0;    ///< moved by more than 2 |e|
  std::size_t beyond_ring_vertices = 0;  ///< moved by more than the longest edge that they had before
  /// Standard deviation of the mesh's noise along its normals, as the guided method sees it, in the mesh's unit. Empty
  /// for other methods.
  std::optional<double> estimated_noise;
  /// Wanted to move farther than the guided method, or SmoothingLimits::max_displacement, lets them.
  std::size_t bounded_vertices = 0;
  /// Movable vertices around which the search for neighbours was cut short, as it would have taken out of all
  /// proportion: a distance may be too large, and a neighbour near the cut-off missing. Of the paper's method; see
  /// docs/algorithm.md.
  std::size_t approximate_neighbourhoods = 0;
  /// Faces of the result that cut through another one; empty unless SmoothingParameters::check asks for it.
  std::optional<std::size_t> self_intersections;
  /// Whether the faces enclose a volume: no border, no edge of three or more faces, all faces of a part look to its
  /// inside or all to its outside.
  bool closed = false;
  /// Distance between neighbouring numbers of the mesh's own precision, at its largest coordinate; isolated vertices
  /// do not count.
  double coordinate_spacing = 0;
  std::vector<std::string> notes;  ///< what the method itself has to say, such as that it found no noise
  std::string advice;              ///< what to use instead where the result is not to be trusted; depends on the method

  /// Sentences for the user: about what in the mesh limits the result, and about a result that is not to be trusted,
  /// each with the remedy. The latter: more than 1 % of the faces are flipped; the volume of a closed mesh changed by
  /// more than 5 %; a vertex moved by more than 2 |e| or by more than its longest edge; a face cuts through another;
  /// coordinate_spacing is more than 1 % of |e|; a tenth of the border vertices are nearly coincident. The notes are
  /// among them. Empty if there is nothing to say.
  std::vector<std::string> warnings() const;
};

}  // namespace vcg_core
