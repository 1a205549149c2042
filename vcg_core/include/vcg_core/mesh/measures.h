// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <vcg_core/errors.h>
#include <vcg_core/mesh/mesh_view.h>
#include <vcg_core/progress.h>

namespace vcg_core {

// What the filters know of a mesh. Each function reads the mesh once, writes nothing, and throws InvalidMesh as
// smooth() does, and Cancelled. Vertices at exactly the same place are one vertex to all of them; counts of vertices
// are of the caller's, deleted ones left out.

struct MeshSummary {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t isolated_vertices = 0;      ///< no face of any extent has them: no face, or faces with a repeated vertex
  std::size_t border_vertices = 0;        ///< on an edge with one face
  std::size_t non_manifold_vertices = 0;  ///< on an edge with three or more faces
  std::size_t coincident_vertices = 0;    ///< at exactly the place of another vertex
  std::size_t degenerate_faces = 0;       ///< with a repeated vertex or without area
  std::size_t edges = 0;                  ///< each once; of a piece those whose first end in the order of space counts
  double average_edge_length = 0;         ///< |e|: mean length of those edges
  /// Signed volume enclosed by the faces, positive if they look outwards; for a mesh with borders, of the cone over it
  /// from the centre of its box.
  double volume = 0;
};

MeshSummary summarize(const MeshView& mesh, const Progress& progress = {});

/// Unit normals, one per vertex: the mean of the normals of the faces around it, weighted by the angle that each has
/// there (the paper leaves the weights open; with angles the normal does not depend on how the surface is cut into
/// triangles). Zero where none is defined: no face, no area, normals that cancel each other; and for deleted vertices.
/// @param threads  0: one for each processor; the result does not depend on it
std::vector<std::array<double, 3>> vertex_normals(const MeshView& mesh, const Progress& progress = {}, int threads = 0);

/// Standard deviation of the mesh's noise along its normals, in the mesh's unit, as the guided filter sees it; 0 if
/// there is no noise that can be told from the shape. docs/guided.md says how it is found. Where there is none that
/// differs from vertex to vertex, it takes as long as smoothing.
double estimate_noise(const MeshView& mesh, const Progress& progress = {}, int threads = 0);

/// Geodesic distance from one vertex to all others by fast marching with a virtual start point, in double precision.
///
/// Source: section 4.1 with its three cases (figures 3 and 4). The code differs from the paper in that a settled vertex
/// is opened again when a face improves it ("label correcting"): in plain Dijkstra order, as the paper implies, obtuse
/// triangles leave errors of several edge lengths. On planar meshes the result is the Euclidean distance up to rounding
/// (figure 5); on curved ones it is the approximation that the paper describes.
///
/// @param source  index of a vertex that is not deleted
/// @return        one distance per vertex, in the mesh's unit; infinity where no path of faces leads (other parts,
///                isolated and deleted vertices)
/// @throws InvalidParameter (source)
std::vector<double> geodesic_distances(const MeshView& mesh, std::size_t source, const Progress& progress = {});

/// Number of faces that cut through another face of the same mesh: each of the two reaches to both sides of the other,
/// and they have a piece of a line in common. Faces that only touch, that lie on top of each other in one plane or that
/// have no area do not count, nor what is no deeper than the rounding of the coordinates.
///
/// vcglib's Clean::SelfIntersections lists the same faces where they cut clearly. In double precision it also lists
/// faces beside each other in one plane, by rounding, and faces with the same three vertices; it can neither be
/// cancelled nor use threads. Time grows with the square of the number of triangles in a fan, as there.
///
/// @param threads  0: one for each processor; the result does not depend on it
std::size_t count_self_intersections(const MeshView& mesh, const Progress& progress = {}, int threads = 0);

}  // namespace vcg_core
