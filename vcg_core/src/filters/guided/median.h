// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "array.h"

namespace vcg_core::detail {

/// Median of at most 2^17 of the values, evenly taken: the same on every machine, and cheap on huge meshes.
/// @param value  is used up; 0 if empty
double median(Array<double> value);

}  // namespace vcg_core::detail
