// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/method.h>
#include <vcg_core/smoothing_limits.h>
#include <vcg_core/smoothing_parameters.h>
#include <vcg_core/smoothing_report.h>

#include "mesh/vertex_attributes.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

class Job;

struct SmoothingResult {
  Array<Vec3> position;    ///< one per vertex, in units of RawMesh::position; equal to it where nothing moves
  SmoothingReport report;  ///< complete but for what the commit counts
};

/// Whether the filter is to smooth vertex attributes as well.
bool smooths_attributes(Method method, const SmoothingParameters& parameters);

/// Runs a smoothing filter on the arrays; the mesh they came from is not touched.
/// @param limits      but for weld_distance, which is read_mesh()'s
/// @param attributes  smoothed as well if there are any
SmoothingResult smooth_arrays(const MeshArrays& mesh, Method method, const SmoothingParameters& parameters,
                              const SmoothingLimits& limits, VertexAttributes& attributes, Job& job);

}  // namespace vcg_core::detail
