// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_filter.h"

namespace vcg_core::detail {

Filter step_filter(Method method, const char* name, const char* title, FilterPass (*make_pass)()) {
  CommonRows<SmoothingParameters> rows;
  rows.iterations.usual = "the paper uses 20";
  SmoothingParameters defaults;
  defaults.iterations = 20;
  return {{method, name, title, {rows.iterations, rows.boundary, rows.selected}, defaults},
          "use fewer iterations, or the guided filter",
          false,
          [make_pass](const SmoothingParameters&) { return make_pass(); }};
}

}  // namespace vcg_core::detail
