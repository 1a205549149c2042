#include "lane_filter.h"

#include <algorithm>
#include <cmath>

#include <vcg_core/detail/job.h>

#include "../paper_filter.h"
#include "lane_kernels.h"
#include "patch_builder.h"

namespace vcg_core::detail {

namespace {

/// Gain, in |e|, that is passed on to the vertices around: a few units in the last place of a distance of ten edges.
constexpr float tolerance = 4e-6f;

LaneParameters lane_parameters(const SmoothingParameters& p) {
  const double log2_e = 1.4426950408889634;
  const double largest = 1e30;  // keeps zero times a coefficient zero
  const double exponent = p.gaussian == GaussianForm::printed ? 1 : 2;
  const double rho = std::min(p.rho * p.sigma_c, 1e14);
  const auto rate = [&](double sigma, double factor) { return std::sqrt(log2_e / factor) / sigma; };
  LaneParameters lanes;
  lanes.cutoff = static_cast<float>(rho);
  lanes.limit = static_cast<float>(rho + march_margin);
  lanes.tolerance = tolerance;
  lanes.closeness = static_cast<float>(std::min(std::pow(rate(p.sigma_c, exponent), 2), largest));
  lanes.similarity = static_cast<float>(std::min(rate(p.sigma_s, exponent), std::sqrt(largest)));
  lanes.normals = static_cast<float>(std::min(rate(p.sigma_n, 2), std::sqrt(largest)));
  return lanes;
}

}  // namespace

LanePass::LanePass() : LanePass(*supported_lane_kernels().front()) {}

LanePass::LanePass(const LaneKernel& kernel) : kernel_(kernel) {}

Array<Vec3> LanePass::run(const PassInput& in) {
  if (!kept_) {
    kept_ = Kept{make_rings(in.mesh, in.job), group_sources(in.mesh, kernel_.lanes, in.job), {}};
    kept_->patch_begin = patch_groups(kept_->groups, in.mesh);
  }
  const SourceGroups& groups = kept_->groups;
  const Array<Index>& patch_begin = kept_->patch_begin;
  const LaneMesh lanes{in.mesh, kept_->ring, groups, in.position, in.normal};
  const LaneParameters constants = lane_parameters(in.parameters);
  const double unit = in.mesh.topology.average_edge_length;
  const double reach = in.parameters.rho * in.parameters.sigma_c + march_margin;
  const LanePoll poll = [](void* chunks) { static_cast<Chunks*>(chunks)->poll(); };
  const auto moves = [&](std::size_t g) {
    return std::any_of(groups.member.begin() + groups.begin[g], groups.member.begin() + groups.begin[g + 1],
                       [&](Index v) { return in.movable[v] != 0; });
  };
  Array<Vec3> moved = in.position;
  const auto smooth_group = [&](const Patch& patch, const PatchGroup& group, Index g, Chunks& chunks) {
    float offset[most_lanes];
    kernel_.march(patch, group, constants, poll, &chunks);
    chunks.poll();
    kernel_.offsets(patch, group, constants, offset);
    for (std::uint32_t lane = 0; lane < group.sources; ++lane) {
      const Index v = groups.member[groups.begin[g] + lane];
      if (in.movable[v]) moved[v] -= in.normal[v] * (static_cast<double>(offset[lane]) * unit);
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
  return moved;
}

}  // namespace vcg_core::detail
