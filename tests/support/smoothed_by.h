// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <support/flat_mesh.h>
#include <support/mesh_types.h>
#include <vcg_core/smoothing.h>

namespace test_support {

/// What a method makes of a mesh, and what it says of it.
struct SmoothedBy {
  FlatMesh mesh;
  vcg_core::SmoothingReport report;
};

/// A copy of `mesh`, smoothed by a method in double precision.
inline SmoothedBy smoothed_by(vcg_core::Method method, const FlatMesh& mesh,
                              const vcg_core::SmoothingParameters& parameters,
                              const vcg_core::Progress& progress = {}) {
  DoubleMesh copy;
  fill(copy, mesh);
  SmoothedBy result;
  result.report = vcg_core::smooth(copy, method, parameters, progress);
  result.mesh = flat(copy);
  return result;
}

/// The same with the method's own defaults.
inline SmoothedBy smoothed_by(vcg_core::Method method, const FlatMesh& mesh) {
  return smoothed_by(method, mesh, vcg_core::method_info(method).defaults);
}

}  // namespace test_support
