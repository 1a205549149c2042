// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring.h"

#include <vcg_core/detail/job.h>

namespace vcg_core::detail {

namespace {

/// Place of each corner in the star of its vertex; most_face_bits at a hub.
Array<std::uint8_t> slots_of_corners(const MeshArrays& mesh, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<std::uint8_t> slot(3 * mesh.face.size());
  job.parallel(mesh.size(), 16384, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        const Index begin = topology.star_begin[v];
        const Index end = topology.star_begin[v + 1];
        for (Index s = begin; s < end; ++s)
          slot[topology.star[s]] = static_cast<std::uint8_t>(end - begin > most_face_bits ? most_face_bits : s - begin);
      }
  });
  return slot;
}

}  // namespace

Array<RingFace> make_rings(const MeshArrays& mesh, Job& job) {
  const Array<std::uint8_t> slot = slots_of_corners(mesh, job);
  Array<RingFace> ring(mesh.topology.star.size());
  job.parallel(ring.size(), 65536, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t s = chunks.begin(); s < chunks.end(); ++s) {
        const Index next = next_in_face(mesh.topology.star[s]);
        const Index previous = previous_in_face(mesh.topology.star[s]);
        ring[s] = {vertex_of(mesh, next), vertex_of(mesh, previous), slot[next], slot[previous]};
      }
  });
  return ring;
}

}  // namespace vcg_core::detail
