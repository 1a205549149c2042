// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace vcg_core::detail {

/// The angle in [0, pi] between two vectors, of |a x b| >= 0 and a . b, not both zero: std::atan2(cross, dot) within
/// 6e-16, in less time, as nothing branches, and with the same bits whatever mathematical library there is.
inline double angle_between(double cross, double dot) {
  constexpr double pi = 3.14159265358979323846;
  constexpr double tan_pi_8 = 0.41421356237309504880;
  const double low = std::min(cross, std::abs(dot));
  const double high = std::max(cross, std::abs(dot));
  // atan(low / high), turned by pi/8 if it is larger than that: what remains, atan(t), has |t| <= tan(pi/8).
  static constexpr double tan_turned[] = {0, tan_pi_8};
  static constexpr double turned[] = {0, pi / 8};
  const int half = low > tan_pi_8 * high ? 1 : 0;
  const double t = (low - tan_turned[half] * high) / (high + tan_turned[half] * low);
  // The polynomial in t^2 that equals atan(t) / t at Chebyshev's nodes of [0, tan^2(pi/8)]: within 7e-17 of it.
  const double w = t * t;
  const double v = w * w;
  const double even =
      1.0 + v * (0.1999999999885511 +
                 v * (0.11111106180455946 +
                      v * (0.07689953496306857 + v * (0.056883492268090106 + v * 0.021135373157693246))));
  const double odd =
      -0.3333333333332844 +
      v * (-0.14285714180976467 + v * (-0.09090773074808414 + v * (-0.06640233930429408 + v * -0.04348052215716462)));
  const double angle = turned[half] + t * (even + w * odd);
  // Back from the first eighth of the circle.
  static constexpr double begin[] = {0, pi / 2, pi, pi / 2};
  static constexpr double sign[] = {1, -1, -1, 1};
  const int eighth = (cross > std::abs(dot) ? 1 : 0) + (dot < 0 ? 2 : 0);
  return begin[eighth] + sign[eighth] * angle;
}

}  // namespace vcg_core::detail
