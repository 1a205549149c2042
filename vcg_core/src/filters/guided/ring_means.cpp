// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_means.h"

#include <algorithm>
#include <vector>

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;

/// Finds what the mean of one vertex after the other is taken over.
class RingOfVertex {
 public:
  RingOfVertex(const MeshArrays& mesh, AtCreases at_creases) : mesh_(mesh), at_creases_(at_creases) {}

  const std::vector<Index>& find(Index v) {
    ring_.clear();
    if (at_creases_ == AtCreases::the_two_along_them && mesh_.topology.is_on_crease(v))
      find_along_crease(v);
    else
      find_neighbours(v);
    if (ring_.empty()) ring_.push_back(v);
    return ring_;
  }

 private:
  void find_neighbours(Index v) {
    const MeshTopology& topology = mesh_.topology;
    for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
      ring_.push_back(vertex_of(mesh_, next_in_face(topology.star[s])));
      ring_.push_back(vertex_of(mesh_, previous_in_face(topology.star[s])));
    }
    std::sort(ring_.begin(), ring_.end());
    for (std::size_t k = 0; k < ring_.size(); k += 2)
      if (ring_[k] != ring_[k + 1] || (k > 0 && ring_[k] == ring_[k - 1])) return;
    ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
  }

  void find_along_crease(Index v) {
    const MeshTopology& topology = mesh_.topology;
    for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
      const Index next = next_in_face(topology.star[s]), previous = previous_in_face(topology.star[s]);
      if (topology.crease[previous]) ring_.push_back(vertex_of(mesh_, next));
      if (topology.crease[next]) ring_.push_back(vertex_of(mesh_, previous));
    }
    std::sort(ring_.begin(), ring_.end());
    ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
    if (ring_.size() != 2) ring_.clear();
  }

  const MeshArrays& mesh_;
  AtCreases at_creases_;
  std::vector<Index> ring_;
};

}  // namespace

RingMeans::RingMeans(const MeshArrays& mesh, Job& job, AtCreases at_creases) : begin_(mesh.size() + 1, 0) {
  const auto for_each_ring = [&](const auto& use) {
    job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
      RingOfVertex ring(mesh, at_creases);
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) use(v, ring.find(static_cast<Index>(v)));
    });
  };
  for_each_ring([&](std::size_t v, const std::vector<Index>& ring) { begin_[v + 1] = ring.size(); });
  job.serial(mesh.size(), [&](std::size_t v) { begin_[v + 1] += begin_[v]; });
  vertex_.resize(begin_.back());
  for_each_ring([&](std::size_t v, const std::vector<Index>& ring) {
    std::copy(ring.begin(), ring.end(), vertex_.begin() + static_cast<std::ptrdiff_t>(begin_[v]));
  });
}

}  // namespace vcg_core::detail
