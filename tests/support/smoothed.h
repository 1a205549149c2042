// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <support/flat_mesh.h>
#include <support/mesh_types.h>
#include <vcg_core/smoothing.h>

namespace test_support {

/// A copy of `mesh`, smoothed by the library in double precision.
inline FlatMesh smoothed(const FlatMesh& mesh, const vcg_core::SmoothingParameters& parameters = {}) {
  DoubleMesh copy;
  fill(copy, mesh);
  vcg_core::smooth(copy, vcg_core::Method::paper, parameters);
  return flat(copy);
}

}  // namespace test_support
