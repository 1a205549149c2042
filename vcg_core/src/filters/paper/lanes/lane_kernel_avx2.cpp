// SPDX-License-Identifier: GPL-3.0-or-later
#include "simd_avx2.h"

#include "lane_kernel.h"

namespace vcg_core::detail {

namespace {

bool supported() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

}  // namespace

extern const LaneKernel avx2_kernel;
const LaneKernel avx2_kernel = {"avx2", Simd::lanes, supported, lane_near, lane_shape, lane_march, lane_offsets};

}  // namespace vcg_core::detail
