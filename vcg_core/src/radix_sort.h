// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Sorts indices by the lowest `bits` bits of their codes, and the codes with them; equal codes keep their order. A
/// comparison sort takes several times as long on a million vertices.
/// @param job  polled, if there is one
void radix_sort(Array<std::uint64_t>& code, Array<Index>& order, int bits, Job* job = nullptr);

}  // namespace vcg_core::detail
