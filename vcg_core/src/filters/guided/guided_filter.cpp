// SPDX-License-Identifier: GPL-3.0-or-later
#include "guided_filter.h"

#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include "array.h"
#include "attribute_smoothing.h"
#include "blend/candidates.h"
#include "correlated_noise.h"
#include "displacement_limit.h"
#include "filter_run.h"
#include "job.h"
#include "polled_copy.h"
#include "told_whole.h"

namespace vcg_core::detail {

namespace {

/// Share of the vertices from which the noise that is seen there counts for the whole mesh without a word.
constexpr double little_evidence = 0.1;

std::string in_percent(double share) {
  std::ostringstream text;
  text << std::setprecision(2) << 100 * share << " %";
  return text.str();
}

PassOutput unchanged(const PassInput& input) {
  PassOutput output{polled_copy(input.position, input.job)};
  output.estimated_noise = 0;
  output.notes.push_back(
      "the mesh shows no noise that can be told from its shape, so nothing was moved; if it is noisy all the same, "
      "use the paper's filter or Taubin's");
  return output;
}

/// Share of the stage at which the trial ends, if there is one.
constexpr double trial_end = 0.5;

NoiseEstimate try_for_correlated_noise(const PassInput& input) {
  const StagePart trial(input.job, 0, trial_end);
  return find_correlated_noise(input);
}

PassOutput hold_to_limits(const PassInput& input, const GuidedSettings& settings, const NoiseEstimate& estimate,
                          const Array<UnitNormal>& normal, Array<Vec3> position) {
  const Array<double> limit =
      displacement_limits(input.mesh, estimate.deviation, settings.most_deviations * settings.noise_scale, input.job);
  Array<std::uint8_t> bounded(input.mesh.size(), 0);
  limit_displacements(input.position, limit, position, bounded, input.job);
  keep_faces_upright(input.mesh, input.position, normal, limit, position, bounded, input.job);
  PassOutput output{std::move(position)};
  output.bounded = std::move(bounded);
  output.estimated_noise = estimate.mean;
  if (estimate.evidence < little_evidence)
    output.notes.push_back("noise can be told from shape around " + in_percent(estimate.evidence) +
                           " of the vertices only; elsewhere they were moved little");
  return output;
}

PassOutput run_within_limits(const PassInput& input, const GuidedSettings& settings, CoarseRounds& coarse) {
  FilterRun run = run_filter(input, settings, coarse);
  return hold_to_limits(input, settings, coarse.estimate(), run.normal, std::move(run.position));
}

}  // namespace

PassOutput guided_pass(const PassInput& input, const GuidedSettings& settings) {
  const ArrayReuse reuse;
  {
    CoarseRounds coarse(input, settings);
    if (coarse.noise() > 0) return run_within_limits(input, settings, coarse);
  }
  if (told_whole(input.mesh) != nullptr) return unchanged(input);
  NoiseEstimate correlated = try_for_correlated_noise(input);
  if (!(correlated.mean > 0)) return unchanged(input);
  const StagePart rest(input.job, trial_end, 1);
  CoarseRounds coarse(input, settings, std::move(correlated));
  return run_within_limits(input, settings, coarse);
}

std::vector<double> medians_of_guided_pass(const PassInput& input, const GuidedSettings& settings,
                                           std::vector<ValueCounts>* counts) {
  const ArrayReuse reuse;
  CoarseRounds coarse(input, settings, told_noise(*told_whole(input.mesh)), counts);
  if (!(coarse.noise() > 0)) return {};
  if (settings.blend) {
    coarse.run();
    median_residual(coarse.take_result(), input.job);
  } else {
    run_filter(input, settings, coarse);
  }
  return coarse.medians().known();
}

namespace {

GuidedSettings settings_of(const SmoothingParameters& all) { return guided_settings(all, all.iterations); }

FilterPass make_guided_pass(const SmoothingParameters& all) {
  return [settings = settings_of(all)](const PassInput& in) { return guided_pass(in, settings); };
}

void smooth_guided_attributes(const MeshArrays& mesh, const Array<Vec3>& position, const Array<std::uint8_t>& movable,
                              const SmoothingParameters& all, VertexAttributes& attributes, Job& job) {
  smooth_attributes(mesh, position, movable, settings_of(all), attributes, job);
}

}  // namespace

Filter guided_filter() {
  SmoothingParameters defaults;
  defaults.iterations = 0;
  defaults.boundary = Boundary::free;  // borders are as noisy as the rest, and the filter does not pull them inwards
  return {
      {Method::guided, "guided", "Guided anisotropic smoothing", guided_parameters<SmoothingParameters>(), defaults},
      "use a lower strength, or select the noisy part only",
      false,
      make_guided_pass,
      true,
      smooth_guided_attributes};
}

}  // namespace vcg_core::detail
