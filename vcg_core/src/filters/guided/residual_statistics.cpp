// SPDX-License-Identifier: GPL-3.0-or-later
#include "residual_statistics.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "job.h"
#include "ramp.h"

namespace vcg_core::detail {

namespace {

/// Low-passes after which little of noise is left, and over how many the local energy is averaged.
constexpr int wide_rings = 37;
constexpr int energy_rings = 56;

template <class Value>
double mean_over(const Array<std::uint8_t>& seen, Job& job, const Value& value) {
  double sum = 0;
  std::size_t count = 0;
  job.serial(seen.size(), [&](std::size_t v) {
    if (!seen[v]) return;
    sum += value(v);
    ++count;
  });
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// Independent deviates, nearly normal, of variance 1.
Array<double> white_noise(std::size_t size, std::uint32_t seed, Job& job) {
  std::mt19937 random(seed);
  Array<double> height(size);
  job.serial(size, [&](std::size_t v) {
    double sum = -3;  // of six deviates between 0 and 1, each of variance 1/12
    for (int k = 0; k < 6; ++k) sum += static_cast<double>(random()) / 4294967296.0;
    height[v] = std::sqrt(2.0) * sum;
  });
  return height;
}

double variance_of(const Residual& residual, Job& job) {
  const Array<double>& r = residual.height;
  return mean_over(residual.seen, job, [&](std::size_t v) { return r[v] * r[v]; });
}

double correlation_of(const RingMeans& rings, const Residual& residual, double variance, Job& job) {
  const Array<double>& r = residual.height;
  return mean_over(residual.seen, job, [&](std::size_t v) { return r[v] * rings.mean(r, v); }) / variance;
}

/// @param variance  above 0
ResidualSpread spread_of(const RingMeans& rings, const Residual& residual, double variance, Job& job) {
  const auto mean = [&](const auto& value) { return mean_over(residual.seen, job, value); };
  const Array<double>& r = residual.height;
  using Around = Eigen::Matrix<double, 3, 1>;
  enum : int { height, energy, vertices };
  Array<Around> around(r.size());
  job.serial(r.size(),
             [&](std::size_t v) { around[v] = residual.seen[v] ? Around(r[v], r[v] * r[v], 1) : Around(0, 0, 0); });
  ResidualSpread spread;
  around = low_pass(rings, std::move(around), wide_rings, job);
  spread.wide = mean([&](std::size_t v) { return around[v][height] * around[v][height]; }) / variance;
  around = low_pass(rings, std::move(around), energy_rings - wide_rings, job);
  const auto local = [&](std::size_t v) { return around[v][energy] / around[v][vertices]; };
  const double everywhere = mean(local);
  const auto difference = [&](std::size_t v) { return local(v) / everywhere - 1; };
  spread.unevenness = std::sqrt(mean([&](std::size_t v) { return difference(v) * difference(v); }));
  return spread;
}

/// Of white noise that is low-passed until it has the correlation, between the two times around it.
ResidualSpread spread_of_low_passed(const RingMeans& rings, Residual noise, double correlation, Job& job) {
  constexpr int most_low_passes = 30;
  double variance = variance_of(noise, job), variance_before = variance;
  double after = correlation_of(rings, noise, variance, job), before = after;
  Array<double> height_before = noise.height;
  for (int time = 0; time < most_low_passes && after < correlation; ++time) {
    height_before = noise.height;
    variance_before = variance;
    before = after;
    noise.height = low_pass(rings, std::move(noise.height), 1, job);
    variance = variance_of(noise, job);
    after = correlation_of(rings, noise, variance, job);
  }
  const ResidualSpread above = spread_of(rings, noise, variance, job);
  if (!(after > before)) return above;
  const ResidualSpread below = spread_of(rings, {std::move(height_before), noise.seen}, variance_before, job);
  const double share = ramp(correlation, before, after);
  return {(1 - share) * below.unevenness + share * above.unevenness, (1 - share) * below.wide + share * above.wide};
}

}  // namespace

ResidualStatistics statistics_of(const RingMeans& rings, const Residual& residual, Job& job) {
  ResidualStatistics of;
  of.variance = variance_of(residual, job);
  if (!(of.variance > 0)) return of;
  const double deviation = std::sqrt(of.variance);
  const auto standard = [&](std::size_t v) { return residual.height[v] / deviation; };
  of.skewness = mean_over(residual.seen, job, [&](std::size_t v) { return standard(v) * standard(v) * standard(v); });
  of.kurtosis = mean_over(residual.seen, job, [&](std::size_t v) {
    const double square = standard(v) * standard(v);
    return square * square;
  });
  of.correlation = correlation_of(rings, residual, of.variance, job);
  of.spread = spread_of(rings, residual, of.variance, job);
  return of;
}

ResidualSpread spread_of_noise(const RingMeans& rings, const Array<std::uint8_t>& seen, double correlation, Job& job) {
  // On a small mesh one draw says little.
  const auto draws = static_cast<std::uint32_t>(std::clamp<std::size_t>(20000 / rings.size(), 1, 6));
  ResidualSpread mean;
  for (std::uint32_t draw = 0; draw < draws; ++draw) {
    const ResidualSpread one =
        spread_of_low_passed(rings, {white_noise(rings.size(), draw + 1, job), seen}, correlation, job);
    mean.unevenness += one.unevenness / draws;
    mean.wide += one.wide / draws;
  }
  return mean;
}

}  // namespace vcg_core::detail
