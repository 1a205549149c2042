// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace anisosmooth_python {

/// Errors of the core and of files as Python's own: ValueError, OSError, and the module's Cancelled.
void declare_errors(nanobind::module_& module);

}  // namespace anisosmooth_python
