// SPDX-License-Identifier: GPL-3.0-or-later
#include "guided_filter.h"

#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include <vcg_core/detail/job.h>

#include "attribute_smoothing.h"
#include "blend/blend.h"
#include "coarse_rounds.h"
#include "detail_recovery.h"
#include "displacement_limit.h"
#include "normal_filter.h"
#include "vertex_update.h"

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
  PassOutput output{input.position};
  output.estimated_noise = 0;
  output.notes.push_back(
      "the mesh shows no noise that can be told from its shape, so nothing was moved; if it is noisy all the same, "
      "use the paper's filter or Taubin's");
  return output;
}

/// The normals after fine rounds: the filter without its blend.
Array<UnitNormal> fine_normals(const CoarseResult& coarse, Job& job) {
  const GuidedSettings& settings = coarse.settings;
  const Array<float> weight = closeness_weights(coarse.within, coarse.faces, coarse.spacing, settings.closeness, job);
  Array<UnitNormal> normal = in_single(coarse.faces.normal, job);
  for (int round = 0; settings.fine && round < settings.fine_rounds; ++round) {
    normal = filter_normals(coarse.within, weight, normal, normal, settings.fine_range, job);
    job.report(0.5 + 0.3 * (round + 1) / settings.fine_rounds);
  }
  return normal;
}

PassOutput hold_to_limits(const PassInput& input, const GuidedSettings& settings, const NoiseEstimate& estimate,
                          const Array<Vec3>& normal, Array<Vec3> position) {
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

}  // namespace

PassOutput guided_pass(const PassInput& input, const GuidedSettings& settings) {
  CoarseRounds coarse(input, settings);
  if (!(coarse.noise() > 0)) return unchanged(input);
  coarse.run();
  CoarseResult result = coarse.take_result();
  Job& job = input.job;
  const Array<Vec3> normal = in_double(settings.blend ? blended_normals(result, job) : fine_normals(result, job), job);
  Array<Vec3> position = settings.restart ? input.position : result.position;
  update_positions(input.mesh, normal, input.movable, settings.final_updates, settings, position, job);
  job.report(0.95);
  if (settings.recover_detail && !settings.blend)
    recover_detail(input.mesh, result.rings, input.position, input.movable, settings, position, job);
  return hold_to_limits(input, settings, coarse.estimate(), normal, std::move(position));
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
