// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <vcg_core/filters/bilateral_parameters.h>
#include <vcg_core/filters/common_parameters.h>

namespace vcg_core {

/// How the paper's filter computes distances and weights. Positions are read and moved in double precision either way.
enum class Arithmetic {
  fast,      ///< in single precision, many vertices at once: within 1e-4 |e| of the other at 99.9 % of the vertices
  reference  ///< in double precision, vertex by vertex, by the plainest code
};

/// What the paper's filter is told. The defaults are those of Table 1.
struct PaperParameters : BilateralParameters {
  double sigma_n = 0.3;
  Arithmetic arithmetic = Arithmetic::fast;  ///< in no table: it changes how long it takes, not what is computed
};

/// All is SmoothingParameters, which is not complete here.
template <class All>
std::vector<ParameterInfo> paper_parameters() {
  const BilateralRows<All> bilateral;
  const CommonRows<All> common;
  return {bilateral.sigma_c,
          bilateral.sigma_s,
          {&All::sigma_n, "sigma_n", "Edge tolerance (sigma_n)",
           "Standard deviation of the normal weight, whose argument is 1 - cosine of the angle between two normals."
           " Higher: the surface is smoothed across steeper edges; lower: more edges are kept, and more noise.",
           above(0), "the paper uses 0.1 to 0.3", ""},
          {&All::rho, "rho", "Cut-off distance (rho), in sigma_c",
           "Geodesic radius of the neighbourhood. Higher: more vertices of little weight take part, and time grows with"
           " the square.",
           above(0), "the paper uses 2", "sigma_c"},
          common.iterations,
          common.boundary,
          common.selected,
          bilateral.gaussian};
}

}  // namespace vcg_core
