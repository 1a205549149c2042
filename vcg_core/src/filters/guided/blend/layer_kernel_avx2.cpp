// SPDX-License-Identifier: GPL-3.0-or-later
#include "simd/simd_avx2.h"

#include "layer_kernel.h"

namespace vcg_core::detail {

extern const LayerKernel avx2_layer_kernel;
const LayerKernel avx2_layer_kernel = {"avx2", Simd::supported, apply_layer<4>};

}  // namespace vcg_core::detail
