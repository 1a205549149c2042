// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend.h"

#include <vcg_core/detail/job.h>

#include "blend_network.h"
#include "blend_weights.h"

namespace vcg_core::detail {

Array<UnitNormal> blended_normals(CoarseResult& coarse, Job& job) {
  Array<UnitNormal> normal = BlendNetwork(first_blend_weights()).blend(first_candidates(coarse, job), job);
  job.report(0.7);
  if (coarse.settings.second_stage)
    normal = BlendNetwork(second_blend_weights()).blend(second_candidates(coarse, normal, job), job);
  job.report(0.85);
  return normal;
}

}  // namespace vcg_core::detail
