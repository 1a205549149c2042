// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace vcg_core::detail {

/// From 0 at `from` to 1 at `full`, which may be the lower one.
inline double ramp(double x, double from, double full) { return std::clamp((x - from) / (full - from), 0.0, 1.0); }

}  // namespace vcg_core::detail
