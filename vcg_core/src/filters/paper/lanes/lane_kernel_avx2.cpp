// SPDX-License-Identifier: GPL-3.0-or-later
#include "simd/simd_avx2.h"

#include "lane_kernel.h"

namespace vcg_core::detail {

extern const LaneKernel avx2_kernel;
const LaneKernel avx2_kernel = {"avx2", Simd::lanes, Simd::supported, lane_near, lane_shape, lane_march, lane_offsets};

}  // namespace vcg_core::detail
