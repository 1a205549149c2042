#include "guided_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vcg_core/detail/job.h>

#include "detail_recovery.h"
#include "face_geometry.h"
#include "face_neighborhoods.h"
#include "guide_normals.h"
#include "noise_estimate.h"
#include "normal_filter.h"
#include "vertex_update.h"

namespace vcg_core::detail {

namespace {

/// What the rounds of one run share.
class GuidedRun {
 public:
  GuidedRun(const PassInput& input, const GuidedSettings& settings)
      : in_(input), settings_(settings), job_(input.job), position_(input.position) {}

  Array<Vec3> run() {
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
    return std::move(position_);
  }

 private:
  void find_neighbourhoods() {
    across_ = faces_across(in_.mesh, job_);
    around_ = faces_around(in_.mesh, across_, job_);
    faces_.measure(in_.mesh, position_, job_);
    normal_ = faces_.normal;
    noise_ = settings_.noise_scale * estimate_noise(in_.mesh, in_.position, faces_, job_);
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
  double noise_ = 0;  ///< standard deviation, in units of the positions
};

}  // namespace

PassOutput guided_pass(const PassInput& input, const GuidedSettings& settings) {
  return PassOutput{GuidedRun(input, settings).run()};
}

PassOutput guided_pass(const PassInput& input) { return guided_pass(input, guided_settings(input.parameters)); }

}  // namespace vcg_core::detail
