// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarse_rounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "face_neighborhoods.h"
#include "faces_around.h"
#include "guide_normals.h"
#include "job.h"
#include "normal_filter.h"
#include "polled_copy.h"
#include "vertex_update.h"

namespace vcg_core::detail {

CoarseRounds::CoarseRounds(const PassInput& input, const GuidedSettings& settings)
    : CoarseRounds(input, settings, {}, nullptr) {
  estimate_ = estimate_noise(in_.mesh, RingMeans(in_.mesh, job_), in_.position, job_);
}

CoarseRounds::CoarseRounds(const PassInput& input, const GuidedSettings& settings, NoiseEstimate noise,
                           std::vector<ValueCounts>* counts)
    : in_(input), settings_(settings), job_(input.job), estimate_(std::move(noise)), medians_(input.mesh, counts) {}

void CoarseRounds::run() {
  position_ = polled_copy(in_.position, job_);
  find_neighbourhoods();
  faces_.measure(in_.mesh, position_, job_);
  const int rounds = settings_.coarse_rounds > 0 ? settings_.coarse_rounds : rounds_for_noise();
  for (int round = 0; round < rounds; ++round) {
    filter_once();
    job_.report(0.1 + 0.4 * (round + 1) / rounds);
  }
  release(across_);
}

CoarseResult CoarseRounds::take_result() {
  return {in_.mesh, settings_,          in_.movable,         in_.position,         estimate_,
          medians_, std::move(within_), std::move(spacing_), std::move(position_), std::move(faces_)};
}

void CoarseRounds::find_neighbourhoods() {
  across_ = faces_across(in_.mesh, job_);
  spacing_ = local_spacing(in_.mesh, settings_.follow_edge_length, settings_.noise_spacing * noise(), job_);
  within_ = faces_within(in_.mesh, across_, position_, spacing_, settings_.radius, job_);
  job_.report(0.1);
}

int CoarseRounds::rounds_for_noise() const {
  const double rounds = settings_.rounds_by_noise * noise() / in_.mesh.topology.average_edge_length;
  return static_cast<int>(std::lround(std::clamp<double>(rounds, settings_.fewest_rounds, settings_.most_rounds)));
}

Array<UnitNormal> CoarseRounds::filtered_normals() {
  // The guides come first: they take the most memory.
  const Array<UnitNormal> guide =
      settings_.guide ? guide_normals(in_.mesh, across_, faces_, settings_, medians_, job_) : faces_.normal;
  const ListWeights weight =
      closeness_weights(within_, in_.mesh, position_, faces_.area, spacing_, settings_.closeness, job_);
  return filter_normals(within_, weight, guide, faces_.normal, settings_.coarse_range, job_);
}

void CoarseRounds::filter_once() {
  update_positions(in_.mesh, filtered_normals(), in_.movable, settings_.coarse_updates, settings_, position_, job_);
  // From here on the normals are those of the faces as they lie: what the vertices could not follow is dropped.
  faces_.measure(in_.mesh, position_, job_);
}

}  // namespace vcg_core::detail
