#pragma once

#include <vcg_core/smoothing_parameters.h>

#include "patch.h"

namespace vcg_core::detail {

/// The filter's constants as the kernels want them.
LaneParameters lane_parameters(const SmoothingParameters& p);

}  // namespace vcg_core::detail
