// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace anisosmooth_python {

/// smooth, distance, estimate_noise, catalogue: the core's functions on arrays.
void declare_smoothing(nanobind::module_& module);

}  // namespace anisosmooth_python
