// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "job.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// A copy that polls: for ten million vertices the system clears and fills 240 MB.
inline Array<Vec3> copy_positions(const Array<Vec3>& position, Job& job) {
  Array<Vec3> copy(position.size());
  job.serial(position.size(), [&](std::size_t v) { copy[v] = position[v]; });
  return copy;
}

}  // namespace vcg_core::detail
