// SPDX-License-Identifier: GPL-3.0-or-later
// The filter itself, per pair (source, vertex nearer than rho), on one core.

#include <cstdint>
#include <string>

#include <benchmark/benchmark.h>

#include "bench_mesh.h"
#include "filters/paper/lanes/lane_filter.h"
#include "filters/paper/lanes/lane_kernels.h"
#include "filters/paper/paper_filter.h"

namespace {

using namespace vcg_core;
using namespace vcg_core::detail;

SmoothingParameters parameters_for(double rho) {
  SmoothingParameters parameters;
  parameters.sigma_c = rho / parameters.rho;
  return parameters;
}

void count(benchmark::State& state, std::size_t pairs) {
  state.counters["pairs"] = static_cast<double>(pairs);
  state.counters["pairs_per_second"] =
      benchmark::Counter(static_cast<double>(pairs), benchmark::Counter::kIsIterationInvariantRate);
}

/// Arguments: rho in |e|; the kernel's place in supported_lane_kernels().
void lanes(benchmark::State& state) {
  const bench::Arrays& arrays = bench::noisy_arrays({});
  const double rho = static_cast<double>(state.range(0));
  const auto kernels = supported_lane_kernels();
  if (static_cast<std::size_t>(state.range(1)) >= kernels.size()) {
    state.SkipWithError("this processor has no such kernel");
    return;
  }
  const LaneKernel& kernel = *kernels[state.range(1)];
  const SmoothingParameters parameters = parameters_for(rho);
  Job job = bench::single_thread();
  for (auto _ : state) {
    LanePass pass(parameters, kernel);  // a new one each time: grouping is part of the filter
    benchmark::DoNotOptimize(pass.run({arrays.mesh, arrays.mesh.position, arrays.normal, arrays.movable, job}));
  }
  state.SetLabel(kernel.name);
  count(state, bench::count_pairs(arrays, rho));
}
BENCHMARK(lanes)->ArgsProduct({{4, 8, 12}, {0, 1, 2}})->Unit(benchmark::kMillisecond);

/// A second pass: rings and groups are kept from the first.
void second_pass(benchmark::State& state) {
  const bench::Arrays& arrays = bench::noisy_arrays({});
  const double rho = static_cast<double>(state.range(0));
  const SmoothingParameters parameters = parameters_for(rho);
  Job job = bench::single_thread();
  LanePass pass(parameters);
  const PassInput input{arrays.mesh, arrays.mesh.position, arrays.normal, arrays.movable, job};
  pass.run(input);
  for (auto _ : state) benchmark::DoNotOptimize(pass.run(input));
  count(state, bench::count_pairs(arrays, rho));
}
BENCHMARK(second_pass)->Arg(4)->Unit(benchmark::kMillisecond);

/// The scalar path in double precision.
void reference(benchmark::State& state) {
  const bench::Arrays& arrays = bench::noisy_arrays({});
  const double rho = static_cast<double>(state.range(0));
  const SmoothingParameters parameters = parameters_for(rho);
  Job job = bench::single_thread();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        paper_pass(arrays.mesh, arrays.mesh.position, arrays.normal, arrays.movable, parameters, job));
  count(state, bench::count_pairs(arrays, rho));
}
BENCHMARK(reference)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace
