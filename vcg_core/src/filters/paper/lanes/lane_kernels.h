// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "patch.h"

namespace vcg_core::detail {

/// The kernels that this processor can run, the fastest first; the last one runs on all.
std::vector<const LaneKernel*> supported_lane_kernels();

}  // namespace vcg_core::detail
