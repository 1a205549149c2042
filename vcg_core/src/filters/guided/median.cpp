// SPDX-License-Identifier: GPL-3.0-or-later
#include "median.h"

#include <algorithm>
#include <cstddef>

namespace vcg_core::detail {

double median(Array<double> value) {
  constexpr std::size_t most_samples = std::size_t(1) << 17;
  if (value.empty()) return 0;
  const std::size_t stride = (value.size() + most_samples - 1) / most_samples;
  std::size_t count = 0;
  for (std::size_t i = 0; i < value.size(); i += stride) value[count++] = value[i];
  value.resize(count);
  const auto middle = value.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(value.begin(), middle, value.end());
  return *middle;
}

}  // namespace vcg_core::detail
