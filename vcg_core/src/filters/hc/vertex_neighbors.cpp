// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_neighbors.h"

#include <algorithm>

#include "job.h"

namespace vcg_core::detail {

namespace {

/// Replaces `found` by the neighbours of v.
void find_neighbors(const MeshArrays& mesh, Index v, Array<Index>& found) {
  const MeshTopology& topology = mesh.topology;
  found.clear();
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    found.push_back(vertex_of(mesh, next_in_face(topology.star[s])));
    found.push_back(vertex_of(mesh, previous_in_face(topology.star[s])));
  }
  std::sort(found.begin(), found.end());
  auto kept = found.begin();
  for (auto it = found.begin(), end = it; it != found.end(); it = end) {
    end = std::find_if(it, found.end(), [it](Index other) { return other != *it; });
    const bool on_border = end - it == 1;  // an edge with one face
    if (on_border || !topology.border[v]) *kept++ = *it;
  }
  found.erase(kept, found.end());
}

}  // namespace

VertexNeighbors vertex_neighbors(const MeshArrays& mesh, Job& job) {
  const std::size_t n = mesh.size();
  VertexNeighbors result;
  result.begin.resize(n + 1, 0);
  const auto for_each_vertex = [&](const auto& visit) {
    job.parallel(n, 4096, Loop::minor, [&](Chunks& chunks) {
      Array<Index> found;
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
          find_neighbors(mesh, static_cast<Index>(v), found);
          visit(v, found);
        }
    });
  };
  for_each_vertex([&](std::size_t v, const Array<Index>& found) { result.begin[v + 1] = found.size(); });
  job.serial(n, [&](std::size_t v) { result.begin[v + 1] += result.begin[v]; });
  result.vertex.resize(result.begin[n]);
  for_each_vertex([&](std::size_t v, const Array<Index>& found) {
    std::copy(found.begin(), found.end(), result.vertex.begin() + static_cast<std::ptrdiff_t>(result.begin[v]));
  });
  return result;
}

}  // namespace vcg_core::detail
