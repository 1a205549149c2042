// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/filters/paper_parameters.h>

#include "patch.h"

namespace vcg_core::detail {

/// The filter's constants as the kernels want them.
LaneParameters lane_parameters(const PaperParameters& p);

}  // namespace vcg_core::detail
