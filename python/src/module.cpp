// SPDX-License-Identifier: GPL-3.0-or-later
#include <nanobind/nanobind.h>

#include "errors.h"
#include "files.h"
#include "smoothing.h"

NB_MODULE(_core, module) {
  anisosmooth_python::declare_errors(module);
  anisosmooth_python::declare_smoothing(module);
  anisosmooth_python::declare_files(module);
  module.attr("version") = ANISO_VERSION;
}
