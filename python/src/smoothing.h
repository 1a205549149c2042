#pragma once

#include <nanobind/nanobind.h>

namespace anisosmooth_python {

/// smooth, distance, estimate_noise, catalogue: the core's functions on arrays.
void declare_smoothing(nanobind::module_& module);

}  // namespace anisosmooth_python
