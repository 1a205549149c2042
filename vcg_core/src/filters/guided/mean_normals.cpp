// SPDX-License-Identifier: GPL-3.0-or-later
#include "mean_normals.h"

#include "job.h"

namespace vcg_core::detail {

Array<Vec3> mean_normals(const MeshArrays& mesh, const Array<UnitNormal>& face_normal, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<Vec3> normal(mesh.size());
  job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        Vec3 sum = Vec3::Zero();
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s)
          sum += in_double(face_normal[topology.star[s] / 3]);
        const double length = sum.norm();
        normal[v] = length > 1e-9 ? Vec3(sum / length) : Vec3(Vec3::Zero());
      }
  });
  return normal;
}

}  // namespace vcg_core::detail
