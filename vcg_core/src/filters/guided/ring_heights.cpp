// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_heights.h"

#include "face_geometry.h"
#include "job.h"

namespace vcg_core::detail {

Array<double> ring_heights(const MeshArrays& mesh, const RingMeans& rings, const Array<Vec3>& position, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<double> height(mesh.size());
  job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        height[v] = 0;
        if (topology.star_begin[v] == topology.star_begin[v + 1]) continue;
        Vec3 normal = Vec3::Zero();
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s)
          normal += direction_of_face(area_vector(mesh, position, topology.star[s] / 3));
        const double length = normal.norm();
        if (length > 0) height[v] = (position[v] - rings.mean(position, v)).dot(normal) / length;
      }
  });
  return height;
}

}  // namespace vcg_core::detail
