// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace vcg_core::detail {

/// max(0, 1 - x/32)^32 for x >= 0: exp(-x) to within 0.009, by six operations that every machine does alike.
template <class Number>
Number nearly_exp_of_minus(Number x) {
  using std::max;  // for vectors of numbers, theirs
  Number power = max(Number(0), Number(1) - x * Number(1.0F / 32));
  for (int squarings = 0; squarings < 5; ++squarings) power *= power;
  return power;
}

/// Gaussian of squared distances d^2, nearly exp(-d^2 / (2 sigma^2)).
template <class Number>
class RangeWeight {
 public:
  explicit RangeWeight(double sigma) : factor_(static_cast<Number>(0.5 / (sigma * sigma))) {}
  /// @tparam Numbers  a number, or several at once
  template <class Numbers>
  Numbers operator()(Numbers squared_distance) const {
    return nearly_exp_of_minus(squared_distance * Numbers(factor_));
  }

 private:
  Number factor_;
};

}  // namespace vcg_core::detail
