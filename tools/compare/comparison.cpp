// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison.h"

#include <utility>

#include "smooth_file.h"

namespace anisosmooth {
namespace {

using vcg_core::Method;

constexpr Method table_1[] = {Method::laplacian, Method::hc, Method::taubin, Method::jones, Method::bmd, Method::paper};

}  // namespace

Positions positions_of(const mesh_tools::Mesh& mesh) {
  Positions positions;
  positions.reserve(mesh.vert.size());
  for (const auto& vertex : mesh.vert) positions.push_back(vertex.cP());
  return positions;
}

void set_positions(mesh_tools::Mesh& mesh, const Positions& positions) {
  for (std::size_t i = 0; i < positions.size(); ++i) mesh.vert[i].P() = positions[i];
}

Comparison compare_methods(mesh_tools::MeshFile noisy, std::optional<mesh_tools::MeshFile> reference, int threads,
                           const vcg_core::Progress& progress) {
  Comparison comparison{std::move(noisy), std::move(reference), {}, {}};
  mesh_tools::MeshFile& file = comparison.noisy;
  const mesh_tools::Mesh* const truth = comparison.reference ? &comparison.reference->mesh : nullptr;
  if (truth) comparison.noisy_figures = mesh_tools::measure(file.mesh, *truth, nullptr, threads);

  for (const Method method : table_1) {
    MethodRun run;
    run.method = vcg_core::method_info(method);
    run.parameters = run.method.defaults;
    run.parameters.threads = threads;
    const double done = static_cast<double>(comparison.runs.size());
    const auto part = [&](double fraction, const char*) {
      return !progress || progress((done + fraction) / std::size(table_1), run.method.title.c_str());
    };
    mesh_tools::FlatFile flat = mesh_tools::to_flat(file);
    const SmoothedFile smoothed = smooth_file(flat, method, run.parameters, part);
    run.report = smoothed.report;
    run.seconds = smoothed.seconds;
    for (std::size_t v = 0; v < flat.mesh.vertices(); ++v) run.positions.push_back(flat.mesh.position[v]);
    comparison.runs.push_back(std::move(run));
  }
  if (truth) {
    mesh_tools::Mesh result;
    vcg::tri::Append<mesh_tools::Mesh, mesh_tools::Mesh>::MeshCopy(result, file.mesh);
    for (MethodRun& run : comparison.runs) {
      set_positions(result, run.positions);
      run.figures = mesh_tools::measure(result, *truth, &file.mesh, threads);
    }
  }
  return comparison;
}

}  // namespace anisosmooth
