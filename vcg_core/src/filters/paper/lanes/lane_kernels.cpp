// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_kernels.h"

#include "simd/supported.h"

namespace vcg_core::detail {

extern const LaneKernel avx512_kernel;
extern const LaneKernel avx2_kernel;
extern const LaneKernel portable_kernel;

std::vector<const LaneKernel*> supported_lane_kernels() {
  return supported<LaneKernel>({
#ifdef VCG_CORE_WIDE_KERNELS
      &avx512_kernel, &avx2_kernel,
#endif
      &portable_kernel});
}

}  // namespace vcg_core::detail
