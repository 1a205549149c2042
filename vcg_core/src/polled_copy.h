// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "array.h"
#include "job.h"

namespace vcg_core::detail {

/// A copy that polls: for the positions of ten million vertices the system clears and fills 240 MB.
template <class T>
Array<T> polled_copy(const Array<T>& original, Job& job) {
  Array<T> copy(original.size());
  job.serial(original.size(), [&](std::size_t i) { copy[i] = original[i]; });
  return copy;
}

}  // namespace vcg_core::detail
