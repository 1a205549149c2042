// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer_kernels.h"

#include "simd/supported.h"

namespace vcg_core::detail {

extern const LayerKernel avx512_layer_kernel;
extern const LayerKernel avx2_layer_kernel;
extern const LayerKernel portable_layer_kernel;

std::vector<const LayerKernel*> supported_layer_kernels() {
  return supported<LayerKernel>({
#ifdef VCG_CORE_WIDE_KERNELS
      &avx512_layer_kernel, &avx2_layer_kernel,
#endif
      &portable_layer_kernel});
}

}  // namespace vcg_core::detail
