// SPDX-License-Identifier: GPL-3.0-or-later
#include "hold_back.h"

#include <cmath>

#include "filters/guided/displacement_limit.h"
#include "job.h"
#include "power_of_two.h"

namespace vcg_core::detail {

void hold_back(const MeshArrays& mesh, const Array<Vec3>& before, const SmoothingLimits& limits, PassOutput& output,
               Job& job) {
  if (!mesh.weight.empty())
    job.serial(mesh.size(), [&](std::size_t v) {
      if (mesh.weight[v] < 1) output.position[v] = before[v] + mesh.weight[v] * (output.position[v] - before[v]);
    });
  if (std::isinf(limits.max_displacement)) return;
  const double limit = PowerOfTwo(mesh.exponent) * limits.max_displacement;
  output.bounded.resize(mesh.size(), 0);
  job.serial(mesh.size(), [&](std::size_t v) {
    if (limit_displacement(mesh.position[v], limit, output.position[v])) output.bounded[v] = 1;
  });
}

}  // namespace vcg_core::detail
