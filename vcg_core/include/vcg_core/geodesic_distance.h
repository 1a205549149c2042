#pragma once

#include <cstddef>
#include <vector>

#include <vcg_core/detail/geodesic_field.h>
#include <vcg_core/detail/job.h>
#include <vcg_core/detail/read_mesh.h>
#include <vcg_core/progress.h>

namespace vcg_core {

/// Geodesic distance from one vertex to all others by fast marching with a virtual start point, in double precision.
///
/// Source: section 4.1 with its three cases (figures 3 and 4). The code differs from the paper in that a settled vertex
/// is opened again when a face improves it ("label correcting"): in plain Dijkstra order, as the paper implies, obtuse
/// triangles leave errors of several edge lengths. On planar meshes the result is the Euclidean distance up to rounding
/// (figure 5); on curved ones it is the approximation that the paper describes.
///
/// @param mesh    any vcglib triangle mesh; deleted elements are passed over, no adjacency is needed
/// @param source  index into mesh.vert of a vertex that is not deleted
/// @return        one distance per element of mesh.vert, in the mesh's unit; infinity where no path of faces leads
///                (other parts, isolated and deleted vertices)
/// @throws InvalidMesh, InvalidParameter (source), Cancelled
template <class Mesh>
std::vector<double> geodesic_distances(const Mesh& mesh, std::size_t source, const Progress& progress = {}) {
  detail::Job job(progress);
  const detail::MeshArrays arrays = detail::read_mesh(mesh, job);
  return detail::geodesic_field(arrays, source, job);
}

}  // namespace vcg_core
