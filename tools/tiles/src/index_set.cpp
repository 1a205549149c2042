// SPDX-License-Identifier: GPL-3.0-or-later
#include "index_set.h"

namespace tiles {
namespace {

std::uint32_t ones(std::uint64_t bits) { return static_cast<std::uint32_t>(__builtin_popcountll(bits)); }

}  // namespace

std::size_t IndexSet::count() {
  below_.resize(bits_.size());
  std::uint32_t sum = 0;
  for (std::size_t word = 0; word < bits_.size(); ++word) {
    below_[word] = sum;
    sum += ones(bits_[word]);
  }
  return sum;
}

std::size_t IndexSet::rank(std::size_t i) const {
  const std::uint64_t below = (std::uint64_t{1} << i % 64) - 1;
  return below_[i / 64] + ones(bits_[i / 64] & below);
}

}  // namespace tiles
