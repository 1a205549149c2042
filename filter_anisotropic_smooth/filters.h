// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter.h"

#include <vector>

namespace meshlab_plugin {

/// All filters of this plugin, in the order of their ids. A new one is an entry at the end.
std::vector<Filter> all_filters();

}  // namespace meshlab_plugin
