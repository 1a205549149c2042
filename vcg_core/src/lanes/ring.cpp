#include "ring.h"

#include <algorithm>

#include <vcg_core/detail/job.h>

namespace vcg_core::detail {

namespace {

/// Place of a corner in the star of its vertex.
std::uint8_t slot_of(const MeshArrays& mesh, Index corner) {
  const Index v = vertex_of(mesh, corner);
  const auto star = mesh.topology.star.begin();
  const auto begin = star + mesh.topology.star_begin[v];
  const auto end = star + mesh.topology.star_begin[v + 1];
  return static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(std::lower_bound(begin, end, corner) - begin, last_slot));
}

}  // namespace

std::vector<RingFace> make_rings(const MeshArrays& mesh, Job& job) {
  std::vector<RingFace> ring(mesh.topology.star.size());
  job.parallel(ring.size(), 16384, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t s = chunks.begin(); s < chunks.end(); ++s) {
        const Index next = next_in_face(mesh.topology.star[s]);
        const Index previous = previous_in_face(mesh.topology.star[s]);
        ring[s] = {vertex_of(mesh, next), vertex_of(mesh, previous), slot_of(mesh, next), slot_of(mesh, previous)};
      }
  });
  return ring;
}

}  // namespace vcg_core::detail
