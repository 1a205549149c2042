// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_filter.h"

#include "filters/step_filter.h"
#include "filters/vcglib_mesh.h"

namespace vcg_core::detail {

namespace {

FilterPass make_laplacian_pass() {
  return make_vcglib_pass([](VcglibMesh& mesh) {
    const auto step = [](SmoothedMesh& m) { vcg::tri::Smooth<SmoothedMesh>::VertexCoordLaplacian(m, 1, true); };
    // From (sum - k v_i) / (k + 2) to 2 (sum - k v_i) / (2 k + 1).
    mesh.step_scaling_borders(step, [](double k) { return 2 * (k + 2) / (2 * k + 1); });
  });
}

}  // namespace

Filter laplacian_filter() {
  return step_filter(Method::laplacian, "laplacian", "Laplacian smoothing", make_laplacian_pass);
}

}  // namespace vcg_core::detail
