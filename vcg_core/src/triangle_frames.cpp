// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_frames.h"

#include <Eigen/Geometry>

#include "job.h"

namespace vcg_core::detail {

template <class Scalar>
TriangleFrame<Scalar> triangle_frame(const MeshArrays& mesh, const Array<Vec3>& position, Index corner, Scalar unit) {
  const auto at = [&](Index c) { return position[vertex_of(mesh, c)].template cast<Scalar>().eval(); };
  const auto v_1 = at(next_in_face(corner));
  const auto along = ((at(previous_in_face(corner)) - v_1) / unit).eval();
  const auto apex = ((at(corner) - v_1) / unit).eval();
  const Scalar edge = along.norm();
  const bool has_edge = edge > 0;
  return {edge, has_edge ? apex.dot(along) / edge : 0, has_edge ? along.cross(apex).norm() / edge : 0, apex.norm(),
          (apex - along).norm()};
}

template <class Scalar>
Array<TriangleFrame<Scalar>> triangle_frames(const MeshArrays& mesh, const Array<Vec3>& position, Scalar unit,
                                             Job& job) {
  Array<TriangleFrame<Scalar>> frames(3 * mesh.face.size());
  job.parallel(mesh.face.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t corner = 3 * chunks.begin(); corner < 3 * chunks.end(); ++corner)
        frames[corner] = triangle_frame(mesh, position, static_cast<Index>(corner), unit);
  });
  return frames;
}

template TriangleFrame<long double> triangle_frame(const MeshArrays&, const Array<Vec3>&, Index, long double);
template Array<TriangleFrame<double>> triangle_frames(const MeshArrays&, const Array<Vec3>&, double, Job&);

}  // namespace vcg_core::detail
