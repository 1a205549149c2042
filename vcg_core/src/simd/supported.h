// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace vcg_core::detail {

/// Those of the kernels that this processor can run.
template <class Kernel>
std::vector<const Kernel*> supported(const std::vector<const Kernel*>& kernels) {
  std::vector<const Kernel*> found;
  std::copy_if(kernels.begin(), kernels.end(), std::back_inserter(found),
               [](const Kernel* k) { return k->supported(); });
  return found;
}

}  // namespace vcg_core::detail
