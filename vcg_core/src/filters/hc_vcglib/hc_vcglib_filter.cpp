// SPDX-License-Identifier: GPL-3.0-or-later
#include "hc_vcglib_filter.h"

#include "filters/step_filter.h"
#include "filters/vcglib_mesh.h"

namespace vcg_core::detail {

namespace {

FilterPass make_hc_vcglib_pass() {
  return make_vcglib_pass(
      [](VcglibMesh& mesh) { vcg::tri::Smooth<SmoothedMesh>::VertexCoordLaplacianHC(mesh.mesh(), 1, true); });
}

}  // namespace

Filter hc_vcglib_filter() {
  return step_filter(Method::hc_vcglib, "hc_vcglib", "Improved Laplacian smoothing as vcglib has it, which shrinks",
                     make_hc_vcglib_pass);
}

}  // namespace vcg_core::detail
