// SPDX-License-Identifier: GPL-3.0-or-later
#include "simd/simd_portable.h"

#include "lane_kernel.h"

namespace vcg_core::detail {

extern const LaneKernel portable_kernel;
const LaneKernel portable_kernel = {"portable", Simd::lanes, Simd::supported, lane_near,
                                    lane_shape, lane_march,  lane_offsets};

}  // namespace vcg_core::detail
