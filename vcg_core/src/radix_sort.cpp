// SPDX-License-Identifier: GPL-3.0-or-later
#include "radix_sort.h"

#include <cstddef>
#include <numeric>

#include "job.h"

namespace vcg_core::detail {

void radix_sort(Array<std::uint64_t>& code, Array<Index>& order, int bits, Job* job) {
  constexpr int digit_bits = 11;
  constexpr std::size_t buckets = std::size_t(1) << digit_bits;
  const auto for_each = [&](const auto& body) {
    if (job != nullptr) return job->serial(code.size(), body);
    for (std::size_t i = 0; i < code.size(); ++i) body(i);
  };
  Array<std::uint64_t> other_code(code.size());
  Array<Index> other_order(order.size());
  for (int shift = 0; shift < bits; shift += digit_bits) {
    std::size_t begin[buckets] = {};
    const auto digit = [shift](std::uint64_t c) { return (c >> shift) & (buckets - 1); };
    for_each([&](std::size_t i) { ++begin[digit(code[i])]; });
    std::exclusive_scan(begin, begin + buckets, begin, std::size_t(0));
    for_each([&](std::size_t i) {
      const std::size_t to = begin[digit(code[i])]++;
      other_code[to] = code[i];
      other_order[to] = order[i];
    });
    code.swap(other_code);
    order.swap(other_order);
  }
}

}  // namespace vcg_core::detail
