// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_run.h"

#include <utility>

#include "blend/blend.h"
#include "detail_recovery.h"
#include "job.h"
#include "normal_filter.h"
#include "polled_copy.h"
#include "vertex_update.h"

namespace vcg_core::detail {

namespace {

/// The normals after fine rounds: the filter without its blend. Frees the coarse faces.
Array<UnitNormal> fine_normals(CoarseResult& coarse, Job& job) {
  const GuidedSettings& settings = coarse.settings;
  const ListWeights weight = closeness_weights(coarse.within, coarse.mesh, coarse.position, coarse.faces.area,
                                               coarse.spacing, settings.closeness, job);
  release(coarse.faces.area);
  Array<UnitNormal> normal = std::move(coarse.faces.normal);
  for (int round = 0; settings.fine && round < settings.fine_rounds; ++round) {
    normal = filter_normals(coarse.within, weight, normal, normal, settings.fine_range, job);
    job.report(0.5 + 0.3 * (round + 1) / settings.fine_rounds);
  }
  return normal;
}

}  // namespace

FilterRun run_filter(const PassInput& input, const GuidedSettings& settings, CoarseRounds& coarse) {
  coarse.run();
  Job& job = input.job;
  FilterRun run;
  {
    CoarseResult result = coarse.take_result();
    if (!settings.restart) run.position = polled_copy(result.position, job);  // before the blend frees them
    run.normal = settings.blend ? blended_normals(result, job) : fine_normals(result, job);
  }
  if (settings.restart) run.position = polled_copy(input.position, job);
  update_positions(input.mesh, run.normal, input.movable, settings.final_updates, settings, run.position, job);
  job.report(0.95);
  if (settings.recover_detail && !settings.blend)
    recover_detail(input.mesh, input.position, input.movable, settings, coarse.medians(), run.position, job);
  return run;
}

}  // namespace vcg_core::detail
