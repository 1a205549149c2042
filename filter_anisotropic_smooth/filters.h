#pragma once

#include "filter.h"

#include <memory>
#include <vector>

namespace meshlab_plugin {

/// All filters of this plugin, in the order of their ids. A new filter is a file of its own and a line there.
std::vector<std::unique_ptr<Filter>> make_filters();

}  // namespace meshlab_plugin
