// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/mesh/value_counts.h>

#include <cmath>
#include <numeric>

namespace vcg_core {

namespace {

/// Bins for each doubling, from 2^lowest to 2^highest. What is less, or more, goes to the first, or last, one.
constexpr int bins_a_doubling = 1024;
constexpr int lowest = -48;
constexpr int highest = 16;
constexpr std::size_t bins = std::size_t(highest - lowest) * bins_a_doubling;

std::size_t bin_of(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // from 1/2 to 1
  if (!(value > 0) || exponent <= lowest) return 0;
  if (exponent > highest) return bins - 1;
  return static_cast<std::size_t>(exponent - 1 - lowest) * bins_a_doubling +
         static_cast<std::size_t>((fraction - 0.5) * 2 * bins_a_doubling);
}

/// Where a bin begins.
double begin_of(std::size_t bin) {
  const auto doubling = static_cast<int>(bin / bins_a_doubling);
  return std::ldexp(1 + static_cast<double>(bin % bins_a_doubling) / bins_a_doubling, lowest + doubling);
}

}  // namespace

void ValueCounts::add(double value) {
  bin_.resize(bins);
  ++bin_[bin_of(value)];
}

void ValueCounts::add(const ValueCounts& others) {
  bin_.resize(bins);
  for (std::size_t bin = 0; bin < others.bin_.size(); ++bin) bin_[bin] += others.bin_[bin];
}

double ValueCounts::median() const {
  const std::uint64_t all = std::accumulate(bin_.begin(), bin_.end(), std::uint64_t{0});
  const double half = static_cast<double>(all) / 2;
  double below = 0;
  for (std::size_t bin = 0; bin < bin_.size(); ++bin) {
    const auto here = static_cast<double>(bin_[bin]);
    if (here > 0 && below + here >= half) {
      const double begin = bin == 0 ? 0 : begin_of(bin);
      return begin + (begin_of(bin + 1) - begin) * (half - below) / here;
    }
    below += here;
  }
  return 0;
}

}  // namespace vcg_core
