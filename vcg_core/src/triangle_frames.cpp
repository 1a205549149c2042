#include "triangle_frames.h"

#include <Eigen/Geometry>

#include <vcg_core/detail/job.h>

namespace vcg_core::detail {

template <class Scalar>
std::vector<TriangleFrame<Scalar>> triangle_frames(const MeshArrays& mesh, const std::vector<Vec3>& position,
                                                   Scalar unit, Job& job) {
  const auto at = [&](Index corner) { return position[vertex_of(mesh, corner)].template cast<Scalar>().eval(); };
  std::vector<TriangleFrame<Scalar>> frames(3 * mesh.face.size());
  job.parallel(mesh.face.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t corner = 3 * chunks.begin(); corner < 3 * chunks.end(); ++corner) {
        const auto c = static_cast<Index>(corner);
        const auto v_1 = at(next_in_face(c));
        const auto along = ((at(previous_in_face(c)) - v_1) / unit).eval();
        const auto apex = ((at(c) - v_1) / unit).eval();
        const Scalar edge = along.norm();
        const bool has_edge = edge > 0;
        frames[corner] = {edge, has_edge ? apex.dot(along) / edge : 0, has_edge ? along.cross(apex).norm() / edge : 0,
                          apex.norm(), (apex - along).norm()};
      }
  });
  return frames;
}

template std::vector<TriangleFrame<double>> triangle_frames(const MeshArrays&, const std::vector<Vec3>&, double, Job&);
template std::vector<TriangleFrame<long double>> triangle_frames(const MeshArrays&, const std::vector<Vec3>&,
                                                                 long double, Job&);

}  // namespace vcg_core::detail
