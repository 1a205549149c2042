// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend.h"

#include <utility>

#include "blend_network.h"
#include "blend_weights.h"
#include "job.h"

namespace vcg_core::detail {

Array<UnitNormal> blended_normals(CoarseResult& coarse, Job& job) {
  const BlendWeights& weights = coarse.noise.correlated ? correlated_noise_weights() : white_noise_weights();
  Array<UnitNormal> normal = BlendNetwork(weights.first).blend(first_candidates(coarse, job), job);
  job.report(0.7);
  if (coarse.settings.second_stage)
    normal = BlendNetwork(weights.second).blend(second_candidates(coarse, std::move(normal), job), job);
  job.report(0.85);
  return normal;
}

}  // namespace vcg_core::detail
