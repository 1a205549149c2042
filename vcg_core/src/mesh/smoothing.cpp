// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/mesh/smoothing.h>

#include <utility>

#include "job.h"
#include "mesh/commit_positions.h"
#include "mesh/read_mesh.h"
#include "mesh/vertex_attributes.h"
#include "smooth_arrays.h"

namespace vcg_core {

SmoothingReport smooth(const MeshView& view, Method method, const SmoothingParameters& parameters,
                       const Progress& progress, const SmoothingLimits& limits) {
  parameters.validate(method);
  limits.validate();
  detail::Job job(progress, parameters.threads);
  const bool with_attributes = detail::smooths_attributes(method, parameters);
  const detail::MeshArrays mesh = detail::read_mesh(view, job, {limits.weld_distance, with_attributes});
  detail::VertexAttributes attributes;
  if (with_attributes) attributes = detail::read_attributes(view, mesh);
  detail::SmoothingResult result = detail::smooth_arrays(mesh, method, parameters, limits, attributes, job);
  job.finish();  // the last moment to cancel: from here on nothing can fail
  detail::commit_positions(mesh, result.position, view, result.report);
  detail::commit_attributes(mesh, attributes, view);
  return std::move(result.report);  // a copy could fail, after the mesh has changed
}

}  // namespace vcg_core
