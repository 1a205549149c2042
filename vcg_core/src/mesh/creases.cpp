// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/creases.h"

#include <algorithm>
#include <utility>

#include "job.h"

namespace vcg_core::detail {

void find_creases(MeshArrays& mesh, Array<std::array<Index, 2>> pairs, Job& job) {
  if (pairs.empty()) return;
  for (auto& [a, b] : pairs)
    if (a > b) std::swap(a, b);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  MeshTopology& topology = mesh.topology;
  topology.crease.assign(3 * mesh.face.size(), 0);
  topology.on_crease.assign(mesh.size(), 0);
  Array<std::uint8_t> is_edge(pairs.size(), 0);
  job.serial(mesh.face.size(), [&](std::size_t f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.face[f][(k + 1) % 3], b = mesh.face[f][(k + 2) % 3];
      const std::array<Index, 2> edge{std::min(a, b), std::max(a, b)};
      const auto place = std::lower_bound(pairs.begin(), pairs.end(), edge);
      if (a == b || place == pairs.end() || *place != edge) continue;
      topology.crease[3 * f + k] = 1;
      topology.on_crease[a] = topology.on_crease[b] = 1;
      is_edge[static_cast<std::size_t>(place - pairs.begin())] = 1;
    }
  });
  topology.crease_edges = static_cast<std::size_t>(std::count(is_edge.begin(), is_edge.end(), 1));
}

void add_faces_of_sector(const MeshArrays& mesh, Index v, Index corner, Array<Index>& found) {
  const MeshTopology& topology = mesh.topology;
  const auto first = static_cast<std::ptrdiff_t>(found.size());
  Array<Index> reached{corner};  // corners at v
  found.push_back(corner / 3);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Index next = next_in_face(reached[i]), previous = previous_in_face(reached[i]);
    // An edge is known by the corner opposite to it: that from v to `next` by `previous`.
    for (const auto& [end, opposite] : {std::pair{next, previous}, std::pair{previous, next}}) {
      if (topology.crease[opposite]) continue;
      for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
        const Index other = topology.star[s];
        const Index w = vertex_of(mesh, end);
        if (vertex_of(mesh, next_in_face(other)) != w && vertex_of(mesh, previous_in_face(other)) != w) continue;
        if (std::find(found.begin() + first, found.end(), other / 3) != found.end()) continue;
        found.push_back(other / 3);
        reached.push_back(other);
      }
    }
  }
}

}  // namespace vcg_core::detail
