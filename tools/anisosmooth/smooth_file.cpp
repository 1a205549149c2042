#include "smooth_file.h"

#include <chrono>

#include <vcg_core/smoothing.h>

namespace anisosmooth {
namespace {

template <class Mesh>
SmoothedFile timed(Mesh& mesh, vcg_core::Method method, const vcg_core::SmoothingParameters& parameters,
                   const vcg_core::Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  SmoothedFile result;
  result.report = vcg_core::smooth(mesh, method, parameters, progress);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace

SmoothedFile smooth_file(mesh_tools::MeshFile& file, vcg_core::Method method,
                         const vcg_core::SmoothingParameters& parameters, const vcg_core::Progress& progress) {
  if (file.precision == mesh_tools::Precision::double_precision) return timed(file.mesh, method, parameters, progress);
  mesh_tools::MeshF mesh;
  mesh_tools::to_single_precision(file.mesh, mesh);
  SmoothedFile result = timed(mesh, method, parameters, progress);
  mesh_tools::take_vertices(mesh, file.mesh);
  return result;
}

}  // namespace anisosmooth
