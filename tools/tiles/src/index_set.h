// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tiles {

/// A set of indices below a limit, as one bit each, that knows how many lie below each member: so members get numbers
/// from 0 on, in their order, without sorting.
class IndexSet {
 public:
  explicit IndexSet(std::size_t limit) : bits_(limit / 64 + 1) {}

  void add(std::size_t i) { bits_[i / 64] |= std::uint64_t{1} << i % 64; }
  bool contains(std::size_t i) const { return bits_[i / 64] >> i % 64 & 1; }

  /// To be called when all are added, before rank().
  /// @return  how many there are
  std::size_t count();
  /// How many members are less than i.
  std::size_t rank(std::size_t i) const;

  /// Calls visit(member) for each, ascending.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t word = 0; word < bits_.size(); ++word)
      for (std::uint64_t left = bits_[word]; left != 0; left &= left - 1)
        visit(64 * word + static_cast<std::size_t>(__builtin_ctzll(left)));
  }

 private:
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> below_;  // by word
};

}  // namespace tiles
