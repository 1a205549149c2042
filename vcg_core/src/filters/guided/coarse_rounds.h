// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coarse_result.h"
#include "filters/filter.h"
#include "noise_estimate.h"
#include "unit_normals.h"
#include "whole_medians.h"

namespace vcg_core::detail {

/// What the rounds of one run share, and the first of them.
class CoarseRounds {
 public:
  /// Estimates the noise.
  CoarseRounds(const PassInput& input, const GuidedSettings& settings);
  /// With what is known of the noise.
  /// @param counts  as WholeMedians has them
  CoarseRounds(const PassInput& input, const GuidedSettings& settings, NoiseEstimate noise,
               std::vector<ValueCounts>* counts = nullptr);

  const NoiseEstimate& estimate() const { return estimate_; }
  /// Standard deviation over the whole mesh that is to be removed, in units of the positions.
  double noise() const { return settings_.noise_scale * estimate_.mean; }

  /// Finds the neighbourhoods and filters normals and positions. To be called once, with noise() above 0.
  void run();

  /// What run() has left; to be called once. It refers to the estimate, the medians and the input.
  CoarseResult take_result();

  /// Of the whole mesh, those that the rounds have gone by; others follow.
  WholeMedians& medians() { return medians_; }

 private:
  void find_neighbourhoods();
  int rounds_for_noise() const;
  Array<UnitNormal> filtered_normals();
  void filter_once();

  const PassInput& in_;
  const GuidedSettings& settings_;
  Job& job_;
  Array<Vec3> position_;
  FaceGeometry faces_;  ///< from run() on
  NoiseEstimate estimate_;
  WholeMedians medians_;
  Array<Index> across_;
  FaceLists within_;
  Array<double> spacing_;
};

}  // namespace vcg_core::detail
