// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlated_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filter_run.h"
#include "held_vertices.h"
#include "job.h"
#include "median.h"
#include "ramp.h"
#include "ring_heights.h"
#include "vertex_normals.h"

namespace vcg_core::detail {

namespace {

/// What the trial takes for noise, in |e|.
constexpr double trial_noise = 0.2;

/// From where to where a residual is believed. Noise correlated over 1.5 to 3 edges, of 0.1 to 0.3 |e|, on machine
/// parts, spheres and tori has a kurtosis of 2.7 to 4.6, at most 2.2 times the unevenness and half of what is left by
/// the wide low-pass. Of 211 clean models two scans alone are inside all of these bounds, and only just.
constexpr double kurtosis_from = 2.35, kurtosis_full = 2.6;
constexpr double kurtosis_to = 4.2, kurtosis_none = 4.7;
constexpr double skewness_to = 0.2, skewness_none = 0.3;
constexpr double unevenness_to = 1.8, unevenness_none = 2.2;
constexpr double wide_to = 0.45, wide_none = 0.55;

/// Vertices: a mesh of two thousand has some dozens of independent places.
constexpr double vertices_from = 1500, vertices_full = 2500;

/// Whether most vertices lie on their rings, so that there is next to no noise, however far it is correlated: of noise
/// of 0.1 |e| that is correlated over three edges, half of the vertices are more than twice as high.
bool is_smooth(const PassInput& input) {
  constexpr double least_height = 0.005;
  Array<double> height = ring_heights(input.mesh, RingMeans(input.mesh, input.job), input.position, input.job);
  for (double& h : height) h = std::abs(h);
  return median(std::move(height)) < least_height * input.mesh.topology.average_edge_length;
}

/// With the networks for white noise: those for correlated noise take away more, of details as well.
Residual residual_of_trial(const PassInput& input) {
  const GuidedSettings settings;
  CoarseRounds coarse(input, settings, even_noise(input.mesh, trial_noise * input.mesh.topology.average_edge_length));
  const FilterRun trial = run_filter(input, settings, coarse);
  const Array<Vec3> normal = vertex_normals(input.mesh, trial.position, input.job);
  Residual residual{Array<double>(input.mesh.size()), input.movable};
  input.job.serial(input.mesh.size(),
                   [&](std::size_t v) { residual.height[v] = (input.position[v] - trial.position[v]).dot(normal[v]); });
  return residual;
}

/// Standard deviation of the noise of which a filter has removed this much: where neighbours agree, the less.
double whole_deviation(const ResidualStatistics& residual) {
  return std::sqrt(residual.variance) / (1 - 0.75 * residual.correlation * residual.correlation);
}

}  // namespace

double trust_in(const ResidualStatistics& residual, const ResidualSpread& noise) {
  return ramp(residual.kurtosis, kurtosis_from, kurtosis_full) * ramp(residual.kurtosis, kurtosis_none, kurtosis_to) *
         ramp(std::abs(residual.skewness), skewness_none, skewness_to) *
         ramp(residual.spread.unevenness / noise.unevenness, unevenness_none, unevenness_to) *
         ramp(residual.spread.wide / noise.wide, wide_none, wide_to);
}

NoiseEstimate find_correlated_noise(const PassInput& input) {
  const auto count = static_cast<double>(
      std::count_if(input.movable.begin(), input.movable.end(), [](std::uint8_t movable) { return movable != 0; }));
  const double enough = ramp(count, vertices_from, vertices_full);
  if (!(enough > 0) || is_smooth(input)) return even_noise(input.mesh, 0);
  const Residual residual = residual_of_trial(input);
  const RingMeans rings(input.mesh, input.job);
  const ResidualStatistics of = statistics_of(rings, residual, input.job);
  if (!(of.variance > 0)) return even_noise(input.mesh, 0);
  const ResidualSpread noise = spread_of_noise(rings, residual.seen, of.correlation, input.job);
  NoiseEstimate found = even_noise(input.mesh, enough * trust_in(of, noise) * whole_deviation(of));
  found.correlated = true;
  return found;
}

double correlated_noise_of(const MeshArrays& mesh, Job& job) {
  const Array<Vec3> no_normals;
  Array<std::uint8_t> movable(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) { movable[v] = !is_isolated(mesh, v); });
  return find_correlated_noise({mesh, mesh.position, no_normals, movable, job}).mean;
}

}  // namespace vcg_core::detail
