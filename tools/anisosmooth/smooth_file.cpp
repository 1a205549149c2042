// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_file.h"

#include <chrono>

#include <vcg_core/mesh/smoothing.h>

#include "file_view.h"

namespace anisosmooth {

SmoothedFile smooth_file(mesh_tools::FlatFile& file, vcg_core::Method method,
                         const vcg_core::SmoothingParameters& parameters, const vcg_core::Progress& progress,
                         const vcg_core::SmoothingLimits& limits, std::vector<double> weights,
                         const std::vector<std::uint8_t>& hidden) {
  FileView mesh(file);
  if (!weights.empty()) mesh.view().weights = vcg_core::real_rows(weights.data(), sizeof(double));
  if (!hidden.empty()) mesh.view().deleted_vertices.data = hidden.data();
  const auto start = std::chrono::steady_clock::now();
  SmoothedFile result;
  result.report = vcg_core::smooth(mesh.view(), method, parameters, progress, limits);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  mesh.take_back();
  return result;
}

}  // namespace anisosmooth
