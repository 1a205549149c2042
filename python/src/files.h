// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace anisosmooth_python {

/// MeshFile, read, write, measure: what the tools know of files and figures.
void declare_files(nanobind::module_& module);

}  // namespace anisosmooth_python
