// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// A number for each index below a size, `none` for nearly all of them: for what a thread has to remember of the
/// vertices or faces near by, of which each thread has its own. Memory follows the stretches of indices in use, and but
/// for 1/64 byte an index not the size.
class SparseIndexMap {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit SparseIndexMap(std::size_t size) : page_(size / page_size + 1, 0), number_(page_size, none) {}

  std::uint32_t operator[](Index i) const { return number_[page_[i / page_size] + i % page_size]; }

  void set(Index i, std::uint32_t number) { exchange(i, number); }

  /// Sets a number and gives what it was.
  std::uint32_t exchange(Index i, std::uint32_t number) {
    std::uint32_t& page = page_[i / page_size];
    if (page == 0) page = take_page(i / page_size);
    return std::exchange(number_[page + i % page_size], number);
  }

  /// Makes all numbers `none` and keeps the memory.
  void clear() {
    for (const Index used : used_) page_[used] = 0;
    std::fill_n(number_.begin() + page_size, used_.size() * page_size, none);
    used_.clear();
  }

 private:
  static constexpr Index page_size = 256;

  std::uint32_t take_page(Index page) {
    used_.push_back(page);
    const std::size_t begin = used_.size() * page_size;
    if (begin == number_.size()) number_.resize(begin + page_size, none);
    return static_cast<std::uint32_t>(begin);
  }

  std::vector<std::uint32_t> page_;    ///< by page of indices: where its numbers begin; 0: nowhere, all are none
  std::vector<std::uint32_t> number_;  ///< the first page stands for all that are not in use
  std::vector<Index> used_;            ///< pages of indices in use, in the order of their numbers
};

}  // namespace vcg_core::detail
