// SPDX-License-Identifier: GPL-3.0-or-later
#include "taubin_filter.h"

#include "filters/step_filter.h"
#include "filters/vcglib_mesh.h"

namespace vcg_core::detail {

namespace {

FilterPass make_taubin_pass() {
  return make_vcglib_pass([](VcglibMesh& mesh) {
    using Smooth = vcg::tri::Smooth<SmoothedMesh>;
    if (!mesh.has_movable_border()) {
      Smooth::VertexCoordTaubin(mesh.mesh(), 1, taubin_lambda, taubin_mu, true);
      return;
    }
    // From (sum - k v_i) / (k + 1) to (sum - k v_i) / k, after each of the two steps: so they are called one by one.
    for (const float step_length : {taubin_lambda, taubin_mu})
      mesh.step_scaling_borders(
          [step_length](SmoothedMesh& m) { Smooth::VertexCoordTaubin(m, 1, step_length, 0, true); },
          [](double k) { return (k + 1) / k; });
  });
}

}  // namespace

Filter taubin_filter() { return step_filter(Method::taubin, "taubin", "Taubin's signal processing", make_taubin_pass); }

}  // namespace vcg_core::detail
