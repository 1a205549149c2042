// SPDX-License-Identifier: GPL-3.0-or-later
// Time per pair (source, vertex nearer than rho) where neighbourhoods are large, and around vertices of many faces.

#include <cstddef>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include <job.h>
#include <mesh/read_mesh.h>
#include <support/high_valence.h>
#include <vcg_core/mesh/vcglib_view.h>

#include "bench_mesh.h"
#include "filters/paper/lanes/lane_filter.h"
#include "vertex_normals.h"

namespace {

using namespace vcg_core;
using namespace vcg_core::detail;

void smooth_pairs(benchmark::State& state, const bench::Arrays& arrays, const SmoothingParameters& parameters) {
  Job job = bench::single_thread();
  for (auto _ : state) {
    LanePass pass(parameters);
    benchmark::DoNotOptimize(pass.run({arrays.mesh, arrays.mesh.position, arrays.normal, arrays.movable, job}));
  }
  state.counters["pairs"] = static_cast<double>(bench::count_pairs(arrays, parameters.rho * parameters.sigma_c));
}

/// Argument: sigma_c. From 20 on 512 vertices move that lie side by side.
void pairs_by_sigma_c(benchmark::State& state, const char* shape) {
  bench::Kind kind;
  kind.shape = shape;
  bench::Arrays arrays = bench::noisy_arrays(kind);
  SmoothingParameters parameters;
  parameters.sigma_c = static_cast<double>(state.range(0));
  if (state.range(0) >= 20)
    for (std::size_t v = 512; v < arrays.movable.size(); ++v) arrays.movable[v] = 0;
  smooth_pairs(state, arrays, parameters);
}
BENCHMARK_CAPTURE(pairs_by_sigma_c, cad_part, "cad_part")
    ->Arg(2)
    ->Arg(6)
    ->Arg(10)
    ->Arg(20)
    ->Arg(50)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs_by_sigma_c, sphere, "sphere")
    ->Arg(2)
    ->Arg(6)
    ->Arg(10)
    ->Arg(20)
    ->Arg(50)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs_by_sigma_c, torus, "torus")
    ->Arg(2)
    ->Arg(6)
    ->Arg(10)
    ->Arg(20)
    ->Arg(50)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

bench::Arrays arrays_of(const test_support::FlatMesh& flat) {
  mesh_tools::Mesh mesh;
  test_support::fill(mesh, flat);
  Job job = bench::single_thread();
  bench::Arrays arrays{read_mesh(vcg_core::view_of(mesh), job), {}, {}};
  arrays.normal = vertex_normals(arrays.mesh, arrays.mesh.position, job);
  for (const Vec3& normal : arrays.normal) arrays.movable.push_back(normal.isZero(0) ? 0 : 1);
  return arrays;
}

/// Argument: faces around the vertices of many.
void many_faces(benchmark::State& state, const std::string& name) {
  for (const auto& [mesh_name, mesh] : test_support::high_valence_meshes(static_cast<std::size_t>(state.range(0))))
    if (mesh_name == name) smooth_pairs(state, arrays_of(mesh), {});
}

const bool registered = [] {
  for (const auto& [name, mesh] : test_support::high_valence_meshes(3)) {
    auto* const benchmark = benchmark::RegisterBenchmark(
        ("many_faces/" + name).c_str(), [name = name](benchmark::State& state) { many_faces(state, name); });
    benchmark->Arg(1000)->Unit(benchmark::kMillisecond);
    if (name == "prism") benchmark->Arg(2000)->Arg(10000);
  }
  return true;
}();

}  // namespace
