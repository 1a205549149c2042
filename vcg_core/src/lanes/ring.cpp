#include "ring.h"

#include <algorithm>

#include <vcg_core/detail/job.h>

namespace vcg_core::detail {

namespace {

/// Place of each corner in the star of its vertex, at most last_slot.
Array<std::uint8_t> slots_of_corners(const MeshArrays& mesh, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<std::uint8_t> slot(3 * mesh.face.size());
  job.parallel(mesh.size(), 16384, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s)
          slot[topology.star[s]] = static_cast<std::uint8_t>(std::min<Index>(s - topology.star_begin[v], last_slot));
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
