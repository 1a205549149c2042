// SPDX-License-Identifier: GPL-3.0-or-later
#include "hc_filter.h"

#include <memory>

#include "filters/step_filter.h"
#include "job.h"
#include "polled_copy.h"
#include "vertex_neighbors.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;  // vertices: well below a millisecond

Vec3 mean_over(const VertexNeighbors& neighbors, Index v, const Array<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = neighbors.begin[v]; k < neighbors.begin[v + 1]; ++k) sum += values[neighbors.vertex[k]];
  return sum / static_cast<double>(neighbors.begin[v + 1] - neighbors.begin[v]);
}

/// Calls step(v) for each vertex that may move, on all threads.
template <class Step>
void for_each_movable(const PassInput& in, Loop loop, const Step& step) {
  in.job.parallel(in.mesh.size(), grain, loop, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        if (in.movable[v]) step(static_cast<Index>(v));
  });
}

PassOutput hc_pass(const PassInput& in, const VertexNeighbors& neighbors) {
  const Array<Vec3>& original = in.mesh.position;
  const Array<Vec3>& before = in.position;
  PassOutput out{polled_copy(before, in.job)};
  Array<Vec3> went(in.mesh.size(), Vec3::Zero());
  for_each_movable(in, Loop::minor, [&](Index v) {
    out.position[v] = mean_over(neighbors, v, before);
    went[v] = out.position[v] - (hc_alpha * original[v] + (1 - hc_alpha) * before[v]);
  });
  for_each_movable(in, Loop::main, [&](Index v) {
    out.position[v] -= hc_beta * went[v] + (1 - hc_beta) * mean_over(neighbors, v, went);
  });
  return out;
}

FilterPass make_hc_pass() {
  // Shared, as a FilterPass can be copied.
  return [neighbors = std::make_shared<VertexNeighbors>()](const PassInput& in) {
    if (neighbors->begin.empty()) *neighbors = vertex_neighbors(in.mesh, in.job);
    return hc_pass(in, *neighbors);
  };
}

}  // namespace

Filter hc_filter() { return step_filter(Method::hc, "hc", "Improved Laplacian smoothing (HC)", make_hc_pass); }

}  // namespace vcg_core::detail
