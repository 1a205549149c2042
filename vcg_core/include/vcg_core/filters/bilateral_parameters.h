// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/parameter_info.h>

namespace vcg_core {

/// The exponent of the three weights. The paper prints W_c and W_s as exp(-x^2 / sigma^2) (section 3) and W_n as
/// exp(-x^2 / (2 sigma^2)) (section 6), yet calls every sigma a standard deviation (section 7).
enum class GaussianForm {
  standard_deviation,  ///< exp(-x^2 / (2 sigma^2)) for all three: the default
  printed              ///< as printed
};

/// What the paper's filter and the two that it starts from, bmd and jones, are told.
struct BilateralParameters {
  double sigma_c = 2.0;
  double sigma_s = 1.0;
  double rho = 2.0;
  GaussianForm gaussian = GaussianForm::standard_deviation;
};

/// The rows that these filters share. All is SmoothingParameters, which is not complete here.
template <class All>
struct BilateralRows {
  static constexpr const char* edge_length = "the mesh's average edge length";

  ParameterInfo sigma_c = {&All::sigma_c,
                           "sigma_c",
                           "Closeness (sigma_c), in average edge lengths",
                           "Standard deviation of the closeness weight. Higher: vertices from farther away take part,"
                           " so larger bumps are smoothed, thin details get lost, and time grows with the square.",
                           above(0),
                           "the paper uses 2 to 6",
                           edge_length};
  ParameterInfo sigma_s = {&All::sigma_s,
                           "sigma_s",
                           "Noise height (sigma_s), in average edge lengths",
                           "Standard deviation of the similarity weight: heights above the tangent plane up to about"
                           " this count as noise. Higher: stronger noise goes, and shallow features with it.",
                           above(0),
                           "the paper uses 0.5 to 2",
                           edge_length};
  ParameterInfo rho = {&All::rho,
                       "rho",
                       "",
                       "Radius of the neighbourhood in a straight line. Higher: more of little weight takes part, and"
                       " time grows with the square.",
                       above(0),
                       "the paper uses 2",
                       "sigma_c"};
  ParameterInfo gaussian = {&All::gaussian, "gaussian", "",
                            "Exponent of the weights. standard_deviation: -x^2 / (2 sigma^2); printed: as in the "
                            "paper's formulas, which for closeness and similarity lack the 2.",
                            one_of({"standard_deviation", "printed"})};
};

}  // namespace vcg_core
