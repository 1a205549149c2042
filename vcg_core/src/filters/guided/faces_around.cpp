// SPDX-License-Identifier: GPL-3.0-or-later
#include "faces_around.h"

#include <algorithm>
#include <vector>

#include "job.h"

namespace vcg_core::detail {

Array<Index> faces_across(const MeshArrays& mesh, Job& job) {
  struct Side {
    Index end;     ///< the edge's other vertex, of higher index
    Index corner;  ///< opposite to the edge
  };
  const MeshTopology& topology = mesh.topology;
  Array<Index> across(3 * mesh.face.size(), no_face);
  job.parallel(mesh.size(), 2048, Loop::minor, [&](Chunks& chunks) {
    std::vector<Side> sides;
    while (chunks.next())
      for (auto v = static_cast<Index>(chunks.begin()); v < chunks.end(); ++v) {
        sides.clear();
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
          const Index corner = topology.star[s];
          const Index next = next_in_face(corner);
          const Index previous = previous_in_face(corner);
          if (vertex_of(mesh, next) > v) sides.push_back({vertex_of(mesh, next), previous});
          if (vertex_of(mesh, previous) > v) sides.push_back({vertex_of(mesh, previous), next});
        }
        std::sort(sides.begin(), sides.end(),
                  [](const Side& a, const Side& b) { return a.end != b.end ? a.end < b.end : a.corner < b.corner; });
        for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
          while (end < sides.size() && sides[end].end == sides[begin].end) ++end;
          if (end - begin != 2) continue;
          if (!topology.crease.empty() && topology.crease[sides[begin].corner]) continue;
          across[sides[begin].corner] = sides[begin + 1].corner / 3;
          across[sides[begin + 1].corner] = sides[begin].corner / 3;
        }
      }
  });
  return across;
}

FacesAround::FacesAround(const MeshArrays& mesh, const Array<Index>& across)
    : mesh_(mesh), across_(across), marks_(mesh.face.size()) {}

const Array<Index>& FacesAround::find(Index f) {
  list_.clear();
  marks_.begin(f);
  const auto add = [&](Index g) {
    if (marks_.add(g)) list_.push_back(g);
  };
  visit_faces_around(mesh_, across_, f, add, [&](Index v) { visit_faces_of(mesh_.topology, v, add); });
  return list_;
}

}  // namespace vcg_core::detail
