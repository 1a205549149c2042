#include "hc_vcglib_filter.h"

#include "filters/vcglib_mesh.h"

namespace vcg_core::detail {

FilterPass make_hc_vcglib_pass() {
  return make_vcglib_pass(
      [](VcglibMesh& mesh) { vcg::tri::Smooth<SmoothedMesh>::VertexCoordLaplacianHC(mesh.mesh(), 1, true); });
}

}  // namespace vcg_core::detail
