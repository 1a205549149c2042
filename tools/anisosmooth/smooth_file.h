#pragma once

#include <mesh_tools/mesh_io.h>
#include <vcg_core/method.h>
#include <vcg_core/progress.h>
#include <vcg_core/smoothing_report.h>

namespace anisosmooth {

struct SmoothedFile {
  vcg_core::SmoothingReport report;
  double seconds = 0;  ///< from the mesh in memory to the mesh in memory
};

/// Smooths in the precision of the file, so that the result is bit for bit what a host with that precision gets.
SmoothedFile smooth_file(mesh_tools::MeshFile& file, vcg_core::Method method,
                         const vcg_core::SmoothingParameters& parameters, const vcg_core::Progress& progress);

}  // namespace anisosmooth
