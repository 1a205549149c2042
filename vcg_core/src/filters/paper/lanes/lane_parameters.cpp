// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_parameters.h"

#include <algorithm>
#include <cmath>

#include "filters/paper/paper_filter.h"

namespace vcg_core::detail {

namespace {

/// A smaller gain, in |e|, is not passed on to the vertices around: a few units in the last place of a distance of ten
/// edges.
constexpr float tolerance = 4e-6f;

/// Scans need one or two, the slivers of a prism that was cut into triangles ear by ear ten to forty.
constexpr std::uint32_t looks_per_corner = 60;

}  // namespace

LaneParameters lane_parameters(const PaperParameters& p) {
  const double log2_e = 1.4426950408889634;
  const double largest = 1e30;  // keeps zero times a coefficient zero
  const double exponent = p.gaussian == GaussianForm::printed ? 1 : 2;
  const double rho = std::min(p.rho * p.sigma_c, 1e14);
  const auto rate = [&](double sigma, double factor) { return std::sqrt(log2_e / factor) / sigma; };
  LaneParameters lanes;
  lanes.cutoff = static_cast<float>(rho);
  lanes.limit = static_cast<float>(rho + march_margin);
  lanes.tolerance = tolerance;
  lanes.looks_per_corner = looks_per_corner;
  lanes.closeness = static_cast<float>(std::min(std::pow(rate(p.sigma_c, exponent), 2), largest));
  lanes.similarity = static_cast<float>(std::min(rate(p.sigma_s, exponent), std::sqrt(largest)));
  lanes.normals = static_cast<float>(std::min(rate(p.sigma_n, 2), std::sqrt(largest)));
  return lanes;
}

}  // namespace vcg_core::detail
