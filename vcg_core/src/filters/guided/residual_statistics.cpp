// SPDX-License-Identifier: GPL-3.0-or-later
#include "residual_statistics.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "job.h"

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

/// Low-passed white noise on the two sides of a correlation.
struct Bracket {
  ResidualStatistics below, above;
  double share = 1;  ///< how far the correlation is from the one to the other
};

Bracket bracket_of(const RingMeans& rings, Residual noise, double correlation, Job& job) {
  constexpr int most_low_passes = 30;
  double before = correlation_of(rings, noise, job), after = before;
  Residual narrower = noise;
  for (int time = 0; time < most_low_passes && after < correlation; ++time) {
    narrower.height = noise.height;
    before = after;
    noise.height = low_pass(rings, std::move(noise.height), 1, job);
    after = correlation_of(rings, noise, job);
  }
  Bracket bracket{statistics_of(rings, narrower, job), statistics_of(rings, noise, job)};
  if (after > before) bracket.share = std::clamp((correlation - before) / (after - before), 0.0, 1.0);
  return bracket;
}

}  // namespace

double correlation_of(const RingMeans& rings, const Residual& residual, Job& job) {
  const Array<double>& r = residual.height;
  const double variance = mean_over(residual.seen, job, [&](std::size_t v) { return r[v] * r[v]; });
  if (!(variance > 0)) return 0;
  return mean_over(residual.seen, job, [&](std::size_t v) { return r[v] * rings.mean(r, v); }) / variance;
}

ResidualStatistics statistics_of(const RingMeans& rings, const Residual& residual, Job& job) {
  const auto mean = [&](const auto& value) { return mean_over(residual.seen, job, value); };
  const Array<double>& r = residual.height;
  ResidualStatistics of;
  of.variance = mean([&](std::size_t v) { return r[v] * r[v]; });
  if (!(of.variance > 0)) return of;
  const double deviation = std::sqrt(of.variance);
  of.skewness = mean([&](std::size_t v) { return std::pow(r[v] / deviation, 3); });
  of.kurtosis = mean([&](std::size_t v) { return std::pow(r[v] / deviation, 4); });

  using Around = Eigen::Matrix<double, 3, 1>;
  enum : int { height, energy, vertices };
  Array<Around> around(r.size());
  job.serial(r.size(),
             [&](std::size_t v) { around[v] = residual.seen[v] ? Around(r[v], r[v] * r[v], 1) : Around(0, 0, 0); });
  around = low_pass(rings, std::move(around), wide_rings, job);
  of.wide = mean([&](std::size_t v) { return around[v][height] * around[v][height]; }) / of.variance;
  around = low_pass(rings, std::move(around), energy_rings - wide_rings, job);
  const auto local = [&](std::size_t v) { return around[v][energy] / around[v][vertices]; };
  const double everywhere = mean(local);
  of.unevenness = std::sqrt(mean([&](std::size_t v) { return std::pow(local(v) / everywhere - 1, 2); }));
  return of;
}

ResidualStatistics statistics_of_noise(const RingMeans& rings, const Array<std::uint8_t>& seen, double correlation,
                                       Job& job) {
  // On a small mesh one draw says little.
  const auto draws = static_cast<std::uint32_t>(std::clamp<std::size_t>(20000 / rings.size(), 1, 6));
  ResidualStatistics of;
  for (std::uint32_t draw = 0; draw < draws; ++draw) {
    const Bracket noise = bracket_of(rings, {white_noise(rings.size(), draw + 1, job), seen}, correlation, job);
    const auto add = [&](double ResidualStatistics::*which) {
      of.*which += ((1 - noise.share) * noise.below.*which + noise.share * noise.above.*which) / draws;
    };
    for (const auto which : {&ResidualStatistics::variance, &ResidualStatistics::kurtosis,
                             &ResidualStatistics::skewness, &ResidualStatistics::unevenness, &ResidualStatistics::wide})
      add(which);
  }
  return of;
}

}  // namespace vcg_core::detail
