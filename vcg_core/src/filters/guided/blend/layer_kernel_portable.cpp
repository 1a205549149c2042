// SPDX-License-Identifier: GPL-3.0-or-later
#include "simd/simd_portable.h"

#include "layer_kernel.h"

namespace vcg_core::detail {

extern const LayerKernel portable_layer_kernel;
const LayerKernel portable_layer_kernel = {"portable", Simd::supported, apply_layer<2>};

}  // namespace vcg_core::detail
