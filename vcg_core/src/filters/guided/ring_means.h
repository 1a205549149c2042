// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>

#include "job.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// What the mean of a vertex on a crease is taken over.
enum class AtCreases { all_neighbours, the_two_along_them };

/// For each vertex those that a mean around it is taken over: its neighbours, each counted once for each face that it
/// shares with the vertex, so inner edges twice; a vertex without faces itself. With `the_two_along_them`, on creases
/// the two neighbours along the crease, and where there are more or fewer than two, the vertex itself.
class RingMeans {
 public:
  RingMeans(const MeshArrays& mesh, Job& job, AtCreases at_creases = AtCreases::all_neighbours);

  std::size_t size() const { return begin_.size() - 1; }

  template <class Value>
  Value mean(const Array<Value>& value, std::size_t v) const {
    const std::size_t begin = begin_[v], end = begin_[v + 1];
    Value sum = value[vertex_[begin]];
    for (std::size_t k = begin + 1; k < end; ++k) sum += value[vertex_[k]];
    return sum / static_cast<double>(end - begin);
  }

 private:
  Array<std::size_t> begin_;  ///< one more than vertices
  Array<Index> vertex_;       ///< where all neighbours of a vertex count twice, each stands here once
};

/// The mean over the ring, the vertex itself with the weight of one neighbour of six; `times` times.
template <class Value>
Array<Value> low_pass(const RingMeans& rings, Array<Value> value, int times, Job& job) {
  Array<Value> mean(value.size());
  for (int time = 0; time < times; ++time) {
    job.parallel(rings.size(), 4096, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
          mean[v] = value[v];
          mean[v] += 6 * rings.mean(value, v);
          mean[v] /= 7;
        }
    });
    value.swap(mean);
  }
  return value;
}

}  // namespace vcg_core::detail
