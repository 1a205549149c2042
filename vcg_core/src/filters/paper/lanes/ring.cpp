// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring.h"

#include <utility>

#include "job.h"

namespace vcg_core::detail {

Rings make_rings(const MeshArrays& mesh, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<std::array<std::uint8_t, 3>> slot(mesh.face.size());
  job.parallel(mesh.size(), 16384, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        const Index begin = topology.star_begin[v];
        const Index end = topology.star_begin[v + 1];
        for (Index s = begin; s < end; ++s)
          slot[topology.star[s] / 3][topology.star[s] % 3] =
              static_cast<std::uint8_t>(end - begin > most_face_bits ? most_face_bits : s - begin);
      }
  });
  return {mesh, std::move(slot)};
}

}  // namespace vcg_core::detail
