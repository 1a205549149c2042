#include "volume.h"

#include <Eigen/Geometry>

namespace vcg_core::detail {

double signed_volume(const MeshArrays& mesh, const Array<Vec3>& position, const Vec3& apex) {
  double sum = 0;
  for (const auto& f : mesh.face)
    sum += (position[f[0]] - apex).dot((position[f[1]] - apex).cross(position[f[2]] - apex));
  return sum / 6;
}

Vec3 box_center(const Array<Vec3>& position) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : position) box.extend(p);
  return box.center();
}

}  // namespace vcg_core::detail
