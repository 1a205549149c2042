// SPDX-License-Identifier: GPL-3.0-or-later
#include "simd_avx512.h"

#include "lane_kernel.h"

namespace vcg_core::detail {

namespace {

bool supported() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}

}  // namespace

extern const LaneKernel avx512_kernel;
const LaneKernel avx512_kernel = {"avx512", Simd::lanes, supported, lane_near, lane_shape, lane_march, lane_offsets};

}  // namespace vcg_core::detail
