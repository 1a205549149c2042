// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <vcg_core/filters/bilateral_parameters.h>

namespace vcg_core::detail {

/// The Gaussian weights of sections 3 and 6. All three are exponentials, so a product of them is one exponential of the
/// summed exponents.
class GaussianWeights {
 public:
  GaussianWeights(double sigma_c, double sigma_s, double sigma_n, GaussianForm form)
      : c_(rate(sigma_c, form == GaussianForm::printed ? 1 : 2)),
        s_(rate(sigma_s, form == GaussianForm::printed ? 1 : 2)),
        n_(rate(sigma_n, 2)) {}

  /// W_c(|v_i - v_j|) W_s(height) W_n(normal_difference), where height is the projection of v_i - v_j and
  /// normal_difference is 1 - n_i.n_j.
  double product(double squared_distance, double height, double normal_difference) const {
    const double s = height * s_;
    const double n = normal_difference * n_;
    return std::exp(-(squared_distance * c_ * c_ + s * s + n * n));
  }

 private:
  /// r such that the weight is exp(-(r x)^2): with the factor in front of sigma^2 inside. Squares are taken after the
  /// product with x, so that neither a tiny nor a huge sigma gives 0 * infinity.
  /// Limited, as the inverse of the smallest doubles is not finite.
  static double rate(double sigma, double factor) { return std::min(1 / (sigma * std::sqrt(factor)), 1e150); }

  double c_;
  double s_;
  double n_;
};

}  // namespace vcg_core::detail
