// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"

namespace vcg_core::detail {

/// What the filters of many small steps have in common: Table 1's number of steps, and nothing else to be told.
Filter step_filter(Method method, const char* name, const char* title, FilterPass (*make_pass)());

}  // namespace vcg_core::detail
