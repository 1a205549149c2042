// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume.h"

#include <cmath>

#include "job.h"

namespace vcg_core::detail {

Eigen::AlignedBox3d bounding_box(const Array<Vec3>& position, Job& job) {
  Eigen::AlignedBox3d box;
  job.serial(position.size(), [&](std::size_t i) { box.extend(position[i]); });
  return box;
}

Eigen::AlignedBox3d box_of_whole(const RawMesh& mesh, Job& job) {
  if (!mesh.whole) return bounding_box(mesh.position, job);
  return {Vec3(mesh.whole->box_min), Vec3(mesh.whole->box_max)};
}

double signed_volume(const MeshArrays& mesh, const Array<Vec3>& position, const Vec3& apex, Job& job) {
  double sum = 0;
  job.serial(mesh.face.size(), [&](std::size_t i) {
    if (!mesh.counts_face(i)) return;
    const auto& f = mesh.face[i];
    sum += (position[f[0]] - apex).dot((position[f[1]] - apex).cross(position[f[2]] - apex));
  });
  return sum / 6;
}

double volume_over_center(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  const Vec3 apex = box_of_whole(mesh, job).center();
  return std::ldexp(signed_volume(mesh, position, apex, job), -3 * mesh.exponent);
}

}  // namespace vcg_core::detail
