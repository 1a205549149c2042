// SPDX-License-Identifier: GPL-3.0-or-later
#include "simd/simd_avx512.h"

#include "layer_kernel.h"

namespace vcg_core::detail {

extern const LayerKernel avx512_layer_kernel;
const LayerKernel avx512_layer_kernel = {"avx512", Simd::supported, apply_layer<8>};

}  // namespace vcg_core::detail
