// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_kernels.h"

namespace vcg_core::detail {

extern const LaneKernel avx512_kernel;
extern const LaneKernel avx2_kernel;
extern const LaneKernel portable_kernel;

std::vector<const LaneKernel*> supported_lane_kernels() {
  std::vector<const LaneKernel*> found;
#ifdef VCG_CORE_WIDE_KERNELS
  if (avx512_kernel.supported()) found.push_back(&avx512_kernel);
  if (avx2_kernel.supported()) found.push_back(&avx2_kernel);
#endif
  found.push_back(&portable_kernel);
  return found;
}

}  // namespace vcg_core::detail
