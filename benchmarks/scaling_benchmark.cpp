// SPDX-License-Identifier: GPL-3.0-or-later
// The whole call, from a vcglib mesh and back, and its steps.

#include <chrono>
#include <thread>

#include <benchmark/benchmark.h>

#include <job.h>
#include <mesh/commit_positions.h>
#include <mesh/read_mesh.h>
#include <smooth_arrays.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vcg_core/smoothing.h>

#include "bench_mesh.h"
#include "vertex_normals.h"

namespace {

using namespace vcg_core;

void per_vertex(benchmark::State& state, std::size_t vertices) {
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["vertices_per_second"] =
      benchmark::Counter(static_cast<double>(vertices), benchmark::Counter::kIsIterationInvariantRate);
}

void copy_mesh(const mesh_tools::Mesh& from, mesh_tools::Mesh& to) {
  // vcglib's copy takes what it only reads by a reference that is not const.
  vcg::tri::Append<mesh_tools::Mesh, mesh_tools::Mesh>::MeshCopy(to, const_cast<mesh_tools::Mesh&>(from));
}

void copy_positions(const mesh_tools::Mesh& from, mesh_tools::Mesh& to) {
  for (std::size_t v = 0; v < from.vert.size(); ++v) to.vert[v].P() = from.vert[v].cP();
}

void smooth_whole(benchmark::State& state, const mesh_tools::Mesh& mesh, const SmoothingParameters& parameters) {
  mesh_tools::Mesh result;
  copy_mesh(mesh, result);
  for (auto _ : state) {
    state.PauseTiming();
    copy_positions(mesh, result);
    state.ResumeTiming();
    smooth(result, Method::paper, parameters);
  }
  per_vertex(state, mesh.vert.size());
}

std::size_t vertices_of(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

SmoothingParameters with_threads(int threads) {
  SmoothingParameters parameters;
  parameters.threads = threads;
  return parameters;
}

/// Argument: vertices.
void size(benchmark::State& state) { smooth_whole(state, bench::noisy_mesh({vertices_of(state)}), with_threads(1)); }
BENCHMARK(size)->Arg(10000)->Arg(100000)->Arg(1000000)->Arg(4000000)->Unit(benchmark::kMillisecond);

void shuffled(benchmark::State& state) {
  smooth_whole(state, bench::noisy_mesh({vertices_of(state), bench::Order::shuffled}), with_threads(1));
}
BENCHMARK(shuffled)->Arg(1000000)->Unit(benchmark::kMillisecond);

/// Argument: threads. In wall time.
void threads(benchmark::State& state) {
  smooth_whole(state, bench::noisy_mesh({1000000}), with_threads(static_cast<int>(state.range(0))));
}
BENCHMARK(threads)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Two calls on one thread each, side by side: what the machine's two processors can do at best.
void side_by_side(benchmark::State& state) {
  const mesh_tools::Mesh& mesh = bench::noisy_mesh({1000000});
  mesh_tools::Mesh result[2];
  for (mesh_tools::Mesh& copy : result) copy_mesh(mesh, copy);
  for (auto _ : state) {
    state.PauseTiming();
    for (mesh_tools::Mesh& copy : result) copy_positions(mesh, copy);
    state.ResumeTiming();
    std::thread other([&] { smooth(result[1], Method::paper, with_threads(1)); });
    smooth(result[0], Method::paper, with_threads(1));
    other.join();
  }
}
BENCHMARK(side_by_side)->Unit(benchmark::kMillisecond)->UseRealTime();

void iterations(benchmark::State& state) {
  SmoothingParameters parameters = with_threads(1);
  parameters.iterations = static_cast<int>(state.range(0));
  smooth_whole(state, bench::noisy_mesh({100000}), parameters);
}
BENCHMARK(iterations)->Arg(1)->Arg(2)->Arg(3)->Unit(benchmark::kMillisecond);

/// Argument: sigma_c.
void sigma_c(benchmark::State& state) {
  SmoothingParameters parameters = with_threads(1);
  parameters.sigma_c = static_cast<double>(state.range(0));
  smooth_whole(state, bench::noisy_mesh({}), parameters);
}
BENCHMARK(sigma_c)->DenseRange(1, 6)->Unit(benchmark::kMillisecond);

void smooth_kind(benchmark::State& state, const bench::Kind& kind) {
  smooth_whole(state, bench::noisy_mesh(kind), with_threads(1));
  const double rho = SmoothingParameters().sigma_c * SmoothingParameters().rho;
  state.counters["pairs"] = static_cast<double>(bench::count_pairs(bench::noisy_arrays(kind), rho));
}

/// Argument: noise in hundredths of |e|.
void noise(benchmark::State& state) {
  bench::Kind kind{100000};
  kind.noise = static_cast<double>(state.range(0)) / 100;
  smooth_kind(state, kind);
}
BENCHMARK(noise)->Arg(0)->Arg(10)->Arg(20)->Arg(40)->Arg(60)->Unit(benchmark::kMillisecond);

/// From a regular grid to edges that differ by a factor of ten.
void shape(benchmark::State& state, const char* name) {
  bench::Kind kind{100000};
  kind.shape = name;
  smooth_kind(state, kind);
}
BENCHMARK_CAPTURE(shape, plane_slash, "plane_slash")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shape, sphere, "sphere")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shape, plane_delaunay, "plane_delaunay")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shape, cube, "cube")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shape, graded_cube, "graded_cube")->Unit(benchmark::kMillisecond);

/// The steps of a whole call one by one, and the share of those around the smoothing itself. In one go, as a machine
/// may change its speed between two measurements.
void steps(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
  mesh_tools::Mesh mesh;
  copy_mesh(bench::noisy_mesh({vertices_of(state)}), mesh);
  detail::Job job = bench::single_thread();
  const SmoothingParameters parameters = with_threads(1);
  detail::VertexAttributes no_attributes;
  double read = 0;
  double normals = 0;
  double smooth = 0;
  double commit = 0;
  for (auto _ : state) {
    const Clock::time_point begin = Clock::now();
    const detail::MeshArrays arrays = detail::read_mesh(vcg_core::view_of(mesh), job);
    const Clock::time_point was_read = Clock::now();
    benchmark::DoNotOptimize(detail::vertex_normals(arrays, arrays.position, job));
    const Clock::time_point had_normals = Clock::now();
    detail::SmoothingResult result = detail::smooth_arrays(arrays, Method::paper, parameters, {}, no_attributes, job);
    const Clock::time_point was_smooth = Clock::now();
    detail::commit_positions(arrays, result.position, view_of(mesh), result.report);
    const Clock::time_point end = Clock::now();
    state.PauseTiming();
    copy_positions(bench::noisy_mesh({vertices_of(state)}), mesh);
    state.ResumeTiming();
    read += seconds(was_read - begin);
    normals += seconds(had_normals - was_read);
    smooth += seconds(was_smooth - had_normals);  // with the normals
    commit += seconds(end - was_smooth);
  }
  const auto mean = [](double sum) { return benchmark::Counter(sum, benchmark::Counter::kAvgIterations); };
  state.counters["read_seconds"] = mean(read);
  state.counters["normals_seconds"] = mean(normals);
  state.counters["commit_seconds"] = mean(commit);
  state.counters["share"] = (read + normals + commit) / (read + smooth + commit);
}
BENCHMARK(steps)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
