// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <mesh_tools/measure.h>
#include <mesh_tools/mesh_io.h>
#include <vcg_core/method.h>
#include <vcg_core/progress.h>
#include <vcg_core/smoothing_report.h>

namespace anisosmooth {

using Positions = std::vector<vcg::Point3d>;

/// What one method made of the noisy mesh.
struct MethodRun {
  vcg_core::MethodInfo method;
  vcg_core::SmoothingParameters parameters;
  vcg_core::SmoothingReport report;
  double seconds = 0;
  Positions positions;
  std::optional<mesh_tools::Measurement> figures;  ///< with a reference
};

/// The six methods of Table 1 on one mesh, in the table's order.
struct Comparison {
  mesh_tools::MeshFile noisy;
  std::optional<mesh_tools::MeshFile> reference;
  std::optional<mesh_tools::Measurement> noisy_figures;
  std::vector<MethodRun> runs;
};

/// Runs the methods with Table 1's parameters on all vertices but those on borders, whatever is selected.
/// @throws mesh_tools::DifferentConnectivity, and what vcg_core::smooth throws
Comparison compare_methods(mesh_tools::MeshFile noisy, std::optional<mesh_tools::MeshFile> reference, int threads,
                           const vcg_core::Progress& progress);

Positions positions_of(const mesh_tools::Mesh& mesh);
void set_positions(mesh_tools::Mesh& mesh, const Positions& positions);

}  // namespace anisosmooth
