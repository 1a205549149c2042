// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>

#include <vcg_core/detail/job.h>
#include <vcg_core/detail/mesh_arrays.h>

namespace vcg_core::detail {

/// Mean of the values at the neighbours of v, each counted once per face that it shares with v: inner edges twice.
/// v must have faces.
template <class Value>
Value ring_mean(const MeshArrays& mesh, const Array<Value>& value, std::size_t v) {
  const MeshTopology& topology = mesh.topology;
  const Index begin = topology.star_begin[v];
  const Index end = topology.star_begin[v + 1];
  Value sum = value[vertex_of(mesh, next_in_face(topology.star[begin]))];
  sum += value[vertex_of(mesh, previous_in_face(topology.star[begin]))];
  for (Index s = begin + 1; s < end; ++s) {
    sum += value[vertex_of(mesh, next_in_face(topology.star[s]))];
    sum += value[vertex_of(mesh, previous_in_face(topology.star[s]))];
  }
  return sum / (2.0 * (end - begin));
}

/// The mean over the one ring, the vertex itself with the weight of one neighbour of six; `rings` times. Vertices
/// without faces keep their value.
template <class Value>
Array<Value> low_pass(const MeshArrays& mesh, Array<Value> value, int rings, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<Value> mean(value.size());
  for (int ring = 0; ring < rings; ++ring) {
    job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
          mean[v] = value[v];
          if (topology.star_begin[v] == topology.star_begin[v + 1]) continue;
          mean[v] += 6 * ring_mean(mesh, value, v);
          mean[v] /= 7;
        }
    });
    value.swap(mean);
  }
  return value;
}

}  // namespace vcg_core::detail
