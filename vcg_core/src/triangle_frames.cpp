#include "triangle_frames.h"

#include <Eigen/Geometry>

#include <vcg_core/detail/job.h>

namespace vcg_core::detail {

std::vector<TriangleFrame<double>> triangle_frames(const MeshArrays& mesh, const std::vector<Vec3>& position,
                                                   double unit, Job& job) {
  std::vector<TriangleFrame<double>> frames(3 * mesh.face.size());
  job.parallel(mesh.face.size(), 4096, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t corner = 3 * chunks.begin(); corner < 3 * chunks.end(); ++corner) {
        const auto c = static_cast<Index>(corner);
        const Vec3& v_1 = position[vertex_of(mesh, next_in_face(c))];
        const Vec3 along = (position[vertex_of(mesh, previous_in_face(c))] - v_1) / unit;
        const Vec3 apex = (position[vertex_of(mesh, c)] - v_1) / unit;
        const double edge = along.norm();
        frames[corner] = {edge, edge > 0 ? apex.dot(along) / edge : 0.0, edge > 0 ? along.cross(apex).norm() / edge : 0.0,
                          apex.norm(), (apex - along).norm()};
      }
  });
  return frames;
}

}  // namespace vcg_core::detail
