// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "cell_set.h"
#include "plan.h"

namespace tiles {

/// Cells that stand for the whole mesh: all of it, if it has at most `most_vertices`; otherwise spots of it, each as
/// wide as its surroundings, as many as have that number of vertices together with them. One after the other they lie
/// where the vertices are, evenly from the first cell to the last, whatever their number.
/// @param reach  how wide the surroundings are, in the mesh's unit
CellSet median_sample(const Plan& plan, double reach, std::size_t most_vertices);

}  // namespace tiles
