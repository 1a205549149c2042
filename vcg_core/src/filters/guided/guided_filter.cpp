// SPDX-License-Identifier: GPL-3.0-or-later
#include "guided_filter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include <vcg_core/detail/job.h>

#include "attribute_smoothing.h"
#include "detail_recovery.h"
#include "displacement_limit.h"
#include "face_geometry.h"
#include "face_neighborhoods.h"
#include "guide_normals.h"
#include "noise_estimate.h"
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

/// What the rounds of one run share.
class GuidedRun {
 public:
  GuidedRun(const PassInput& input, const GuidedSettings& settings)
      : in_(input), settings_(settings), job_(input.job), position_(input.position) {}

  PassOutput run() {
    measure_noise();
    if (!(noise_ > 0)) return unchanged();
    find_neighbourhoods();
    const int rounds = settings_.coarse_rounds > 0 ? settings_.coarse_rounds : rounds_for_noise();
    for (int round = 0; round < rounds; ++round) {
      coarse_round();
      job_.report(0.1 + 0.5 * (round + 1) / rounds);
    }
    if (settings_.fine) fine_rounds();
    if (settings_.restart) position_ = in_.position;
    update_positions(in_.mesh, normal_, in_.movable, settings_.final_updates, settings_, position_, job_);
    job_.report(0.95);
    if (settings_.recover_detail)
      detail::recover_detail(in_.mesh, in_.position, in_.movable, settings_, position_, job_);
    return hold_to_limits();
  }

 private:
  void measure_noise() {
    faces_.measure(in_.mesh, position_, job_);
    normal_ = faces_.normal;
    estimate_ = estimate_noise(in_.mesh, in_.position, faces_, job_);
    noise_ = settings_.noise_scale * estimate_.mean;
  }

  PassOutput unchanged() {
    PassOutput output{in_.position};
    output.estimated_noise = 0;
    output.notes.push_back(
        "the mesh shows no noise that can be told from its shape, so nothing was moved; if it is noisy all the same, "
        "use the paper's filter or Taubin's");
    return output;
  }

  PassOutput hold_to_limits() {
    const Array<double> limit =
        displacement_limits(in_.mesh, estimate_.deviation, settings_.most_deviations * settings_.noise_scale, job_);
    Array<std::uint8_t> bounded(in_.mesh.size(), 0);
    limit_displacements(in_.position, limit, position_, bounded, job_);
    keep_faces_upright(in_.mesh, in_.position, normal_, limit, position_, bounded, job_);
    PassOutput output{std::move(position_)};
    output.bounded = std::move(bounded);
    output.estimated_noise = estimate_.mean;
    if (estimate_.evidence < little_evidence)
      output.notes.push_back("noise can be told from shape around " + in_percent(estimate_.evidence) +
                             " of the vertices only; elsewhere they were moved little");
    return output;
  }

  void find_neighbourhoods() {
    across_ = faces_across(in_.mesh, job_);
    around_ = faces_around(in_.mesh, across_, job_);
    spacing_ = local_spacing(in_.mesh, settings_.follow_edge_length, settings_.noise_spacing * noise_, job_);
    within_ = faces_within(around_, faces_.centroid, spacing_, settings_.radius, job_);
    job_.report(0.1);
  }

  int rounds_for_noise() const {
    const double rounds = settings_.rounds_by_noise * noise_ / in_.mesh.topology.average_edge_length;
    return static_cast<int>(std::lround(std::clamp<double>(rounds, settings_.fewest_rounds, settings_.most_rounds)));
  }

  void coarse_round() {
    const Array<double> weight = closeness_weights(within_, faces_, spacing_, settings_.closeness, job_);
    const Array<Vec3> guide =
        settings_.guide ? guide_normals(around_, across_, faces_, normal_, settings_, job_) : normal_;
    normal_ = filter_normals(within_, weight, guide, normal_, settings_.coarse_range, job_);
    update_positions(in_.mesh, normal_, in_.movable, settings_.coarse_updates, settings_, position_, job_);
    // From here on the normals are those of the faces as they lie: what the vertices could not follow is dropped.
    faces_.measure(in_.mesh, position_, job_);
    normal_ = faces_.normal;
  }

  void fine_rounds() {
    const Array<double> weight = closeness_weights(within_, faces_, spacing_, settings_.closeness, job_);
    for (int round = 0; round < settings_.fine_rounds; ++round) {
      normal_ = filter_normals(within_, weight, normal_, normal_, settings_.fine_range, job_);
      job_.report(0.6 + 0.3 * (round + 1) / settings_.fine_rounds);
    }
  }

  const PassInput& in_;
  const GuidedSettings& settings_;
  Job& job_;
  Array<Vec3> position_;
  Array<Vec3> normal_;
  Array<Index> across_;
  FaceLists around_;
  FaceLists within_;
  Array<double> spacing_;
  FaceGeometry faces_;
  NoiseEstimate estimate_;
  double noise_ = 0;  ///< standard deviation over the whole mesh that is to be removed, in units of the positions
};

}  // namespace

PassOutput guided_pass(const PassInput& input, const GuidedSettings& settings) {
  return GuidedRun(input, settings).run();
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
