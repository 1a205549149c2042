#pragma once

#include <utility>

#include <vcg_core/detail/commit_positions.h>
#include <vcg_core/detail/job.h>
#include <vcg_core/detail/read_mesh.h>
#include <vcg_core/detail/smooth_arrays.h>
#include <vcg_core/errors.h>
#include <vcg_core/method.h>
#include <vcg_core/progress.h>
#include <vcg_core/smoothing_parameters.h>
#include <vcg_core/smoothing_report.h>

namespace vcg_core {

/// Smooths `mesh` in place: moves vertices, changes nothing else but colour and quality on request (normals, bounding
/// box and attributes are the caller's). docs/algorithm.md holds the equations and where the code differs from the
/// paper.
///
/// @param mesh  any vcglib triangle mesh, float or double, with or without optional components; deleted elements are
///              passed over, no adjacency is needed, the selection is read and never changed
/// @return      what was done, lengths in the mesh's unit
/// @throws InvalidParameter, InvalidMesh, Cancelled; the mesh is then bit for bit as it was
template <class Mesh>
SmoothingReport smooth(Mesh& mesh, Method method, const SmoothingParameters& parameters = {},
                       const Progress& progress = {}) {
  parameters.validate(method);
  detail::Job job(progress, parameters.threads);
  const detail::MeshArrays arrays = detail::read_mesh(mesh, job);
  detail::VertexAttributes attributes;
  if (detail::smooths_attributes(method, parameters)) attributes = detail::read_attributes(mesh, arrays);
  detail::SmoothingResult result = detail::smooth_arrays(arrays, method, parameters, attributes, job);
  job.finish();  // the last moment to cancel: from here on nothing can fail
  detail::commit_positions(arrays, result.position, mesh, result.report);
  detail::commit_attributes(arrays, attributes, mesh);
  return std::move(result.report);  // a copy could fail, after the mesh has changed
}

}  // namespace vcg_core
