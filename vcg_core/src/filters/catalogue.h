// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filters/filter.h"

namespace vcg_core::detail {

/// All filters, in the order of Method. This is the one place that knows them all.
const std::vector<Filter>& catalogue();

const Filter& filter_of(Method method);

}  // namespace vcg_core::detail
