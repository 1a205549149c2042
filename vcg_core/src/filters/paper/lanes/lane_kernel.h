// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The kernel that runs the paper's filter for a group of sources at once, one a lane. Included once by each of the
// files lane_kernel_*.cpp, after the Simd of their processor; no standard library in these headers, as its inline
// functions would be compiled for that processor and might be linked into code that runs on all.

#include "lane_march.h"
#include "lane_near.h"
#include "lane_offsets.h"
#include "lane_shape.h"
