#pragma once

#include <vector>

#include <vcg_core/detail/mesh_arrays.h>
#include <vcg_core/method.h>
#include <vcg_core/smoothing_parameters.h>
#include <vcg_core/smoothing_report.h>

namespace vcg_core::detail {

class Job;

struct SmoothingResult {
  std::vector<Vec3> position;  ///< one per vertex, in units of RawMesh::position; equal to it where nothing moves
  SmoothingReport report;      ///< complete but for what the commit counts
};

/// Runs a smoothing filter on the arrays; the mesh they came from is not touched.
SmoothingResult smooth_arrays(const MeshArrays& mesh, Method method, const SmoothingParameters& parameters, Job& job);

}  // namespace vcg_core::detail
