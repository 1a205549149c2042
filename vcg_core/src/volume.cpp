// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume.h"

#include <cmath>

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

double volume_over_center(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  const Vec3 apex = bounding_box(mesh.position, job).center();
  return std::ldexp(signed_volume(mesh, position, apex, job), -3 * mesh.exponent);
}

}  // namespace vcg_core::detail
