// SPDX-License-Identifier: GPL-3.0-or-later
#include "guided_settings.h"

#include <cmath>

namespace vcg_core::detail {

namespace {

/// The feature angle, in degrees, at which the range sigmas have their values in GuidedSettings.
constexpr double reference_angle = 30;

double chord(double degrees) { return 2 * std::sin(degrees * std::acos(-1.0) / 360); }

}  // namespace

GuidedSettings guided_settings(const GuidedParameters& parameters, int coarse_rounds) {
  GuidedSettings settings;
  const double range_scale = parameters.strength * chord(parameters.feature_angle) / chord(reference_angle);
  settings.coarse_range *= range_scale;
  settings.fine_range *= range_scale;
  settings.ring_range_floor *= range_scale;
  settings.noise_scale = parameters.strength;
  settings.coarse_rounds = coarse_rounds;
  settings.blend = parameters.blend == Blend::on;
  return settings;
}

}  // namespace vcg_core::detail
