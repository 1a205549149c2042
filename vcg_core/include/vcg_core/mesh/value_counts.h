// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vcg_core {

/// A distribution of numbers of 0 or more, counted in bins of a thousandth of their size, so that the counts of pieces
/// add up to those of the whole.
class ValueCounts {
 public:
  void add(double value);
  void add(const ValueCounts& others);

  /// Half of the values are below; found to about a hundred-thousandth of its size, as values within a bin are taken to
  /// lie evenly. 0 if there are no values.
  double median() const;

 private:
  std::vector<std::uint64_t> bin_;
};

}  // namespace vcg_core
