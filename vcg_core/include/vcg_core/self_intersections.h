#pragma once

#include <cstddef>

#include <vcg_core/detail/count_intersections.h>
#include <vcg_core/detail/job.h>
#include <vcg_core/detail/read_mesh.h>
#include <vcg_core/progress.h>

namespace vcg_core {

/// Number of faces that cut through another face of the same mesh: each of the two reaches to both sides of the other,
/// and they have a piece of a line in common. Faces that only touch, that lie on top of each other in one plane or that
/// have no area do not count, nor what is no deeper than the rounding of the coordinates.
///
/// vcglib's Clean::SelfIntersections lists the same faces where they cut clearly. In double precision it also lists
/// faces beside each other in one plane, by rounding, and faces with the same three vertices; it can neither be
/// cancelled nor use threads. Time grows with the square of the number of triangles in a fan, as there.
///
/// @param mesh     any vcglib triangle mesh; deleted elements are passed over, no adjacency is needed
/// @param threads  0: one for each processor; the result does not depend on it
/// @throws InvalidMesh, Cancelled
template <class Mesh>
std::size_t count_self_intersections(const Mesh& mesh, const Progress& progress = {}, int threads = 0) {
  detail::Job job(progress, threads);
  const detail::MeshArrays arrays = detail::read_mesh(mesh, job);
  job.begin_stage("Looking for self-intersections", 1);
  return detail::count_self_intersections(arrays, arrays.position, job);
}

}  // namespace vcg_core
