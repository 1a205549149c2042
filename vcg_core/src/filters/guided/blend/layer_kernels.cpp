// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer_kernels.h"

namespace vcg_core::detail {

extern const LayerKernel avx512_layer_kernel;
extern const LayerKernel avx2_layer_kernel;
extern const LayerKernel portable_layer_kernel;

std::vector<const LayerKernel*> supported_layer_kernels() {
  std::vector<const LayerKernel*> found;
#ifdef VCG_CORE_WIDE_KERNELS
  if (avx512_layer_kernel.supported()) found.push_back(&avx512_layer_kernel);
  if (avx2_layer_kernel.supported()) found.push_back(&avx2_layer_kernel);
#endif
  found.push_back(&portable_layer_kernel);
  return found;
}

}  // namespace vcg_core::detail
