// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <mesh_tools/mesh_io.h>
#include <vcg_core/method.h>
#include <vcg_core/progress.h>
#include <vcg_core/smoothing_limits.h>
#include <vcg_core/smoothing_report.h>

namespace anisosmooth {

struct SmoothedFile {
  vcg_core::SmoothingReport report;
  double seconds = 0;  ///< from the mesh in memory to the mesh in memory
};

/// Smooths in the precision of the file.
/// @param weights  as MeshView has them; empty: all 1
/// @param hidden   a mark for each vertex that the filter passes over; empty: none
SmoothedFile smooth_file(mesh_tools::FlatFile& file, vcg_core::Method method,
                         const vcg_core::SmoothingParameters& parameters, const vcg_core::Progress& progress,
                         const vcg_core::SmoothingLimits& limits = {}, std::vector<double> weights = {},
                         const std::vector<std::uint8_t>& hidden = {});

}  // namespace anisosmooth
