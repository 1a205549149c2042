// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter.h"

namespace meshlab_plugin {

/// Geodesic distances from one vertex, as vertex quality and colour: the paper's figures 5b and 6b.
Filter geodesic_distance_filter();

}  // namespace meshlab_plugin
