// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_filter.h"

#include <algorithm>
#include <atomic>

#include "filters/paper/paper_filter.h"
#include "job.h"
#include "lane_kernels.h"
#include "lane_parameters.h"
#include "patch_builder.h"
#include "polled_copy.h"

namespace vcg_core::detail {

LanePass::LanePass(const PaperParameters& parameters) : LanePass(parameters, *supported_lane_kernels().front()) {}

LanePass::LanePass(const PaperParameters& parameters, const LaneKernel& kernel)
    : parameters_(parameters), kernel_(kernel) {}

PassOutput LanePass::run(const PassInput& in) {
  if (!kept_) {
    kept_ = Kept{make_rings(in.mesh, in.job), group_sources(in.mesh, kernel_.lanes, in.job), {}};
    in.job.poll();
    kept_->patch_begin = patch_groups(kept_->groups, in.mesh);
    in.job.poll();
  }
  const SourceGroups& groups = kept_->groups;
  const Array<Index>& patch_begin = kept_->patch_begin;
  const LaneMesh lanes{in.mesh, kept_->ring, groups, in.position, in.normal};
  const LaneParameters constants = lane_parameters(parameters_);
  const double unit = in.mesh.topology.average_edge_length;
  const double reach = parameters_.rho * parameters_.sigma_c + march_margin;
  const LanePoll poll = [](void* chunks) { static_cast<Chunks*>(chunks)->poll(); };
  const auto moves = [&](std::size_t g) {
    return std::any_of(groups.member.begin() + groups.begin[g], groups.member.begin() + groups.begin[g + 1],
                       [&](Index v) { return in.movable[v] != 0; });
  };
  PassOutput out{polled_copy(in.position, in.job)};
  std::atomic<std::size_t> approximate{0};
  const auto smooth_group = [&](const Patch& patch, const PatchGroup& group, Index g, Chunks& chunks) {
    float offset[most_lanes];
    const bool loosened = kernel_.march(patch, group, constants, poll, &chunks).loosened;
    chunks.poll();
    kernel_.offsets(patch, group, constants, offset);
    for (std::uint32_t lane = 0; lane < group.sources; ++lane) {
      const Index v = groups.member[groups.begin[g] + lane];
      if (!in.movable[v]) continue;
      out.position[v] -= in.normal[v] * (static_cast<double>(offset[lane]) * unit);
      if (loosened) approximate += in.mesh.counted(v);
    }
  };
  in.job.parallel(patch_begin.size() - 1, 2, [&](Chunks& chunks) {
    PatchBuilder builder(lanes, kernel_);
    while (chunks.next())
      for (std::size_t p = chunks.begin(); p < chunks.end(); ++p) {
        const Patch* patch = nullptr;
        for (Index g = patch_begin[p]; g < patch_begin[p + 1]; ++g) {
          if (!moves(g)) continue;
          chunks.poll();  // a patch may be the whole mesh
          if (patch == nullptr) {
            patch = &builder.build(patch_begin[p], patch_begin[p + 1], reach, [&] { chunks.poll(); });
            chunks.poll();
            kernel_.shape(*patch, poll, &chunks);
          }
          smooth_group(*patch, builder.group(g), g, chunks);
        }
      }
  });
  out.approximate_neighbourhoods = approximate;
  return out;
}

}  // namespace vcg_core::detail
