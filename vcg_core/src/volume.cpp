#include "volume.h"

#include <vcg_core/detail/job.h>

namespace vcg_core::detail {

Eigen::AlignedBox3d bounding_box(const Array<Vec3>& position, Job& job) {
  Eigen::AlignedBox3d box;
  job.serial(position.size(), [&](std::size_t i) { box.extend(position[i]); });
  return box;
}

double signed_volume(const MeshArrays& mesh, const Array<Vec3>& position, const Vec3& apex, Job& job) {
  double sum = 0;
  job.serial(mesh.face.size(), [&](std::size_t i) {
    const auto& f = mesh.face[i];
    sum += (position[f[0]] - apex).dot((position[f[1]] - apex).cross(position[f[2]] - apex));
  });
  return sum / 6;
}

}  // namespace vcg_core::detail
