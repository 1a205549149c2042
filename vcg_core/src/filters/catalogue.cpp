#include "catalogue.h"

#include <algorithm>
#include <memory>

#include "filters/bmd/bmd_filter.h"
#include "filters/guided/guided_filter.h"
#include "filters/hc/hc_filter.h"
#include "filters/hc_vcglib/hc_vcglib_filter.h"
#include "filters/jones/jones_filter.h"
#include "filters/laplacian/laplacian_filter.h"
#include "filters/paper/lanes/lane_filter.h"
#include "filters/paper/paper_filter.h"
#include "filters/taubin/taubin_filter.h"

namespace vcg_core::detail {

namespace {

FilterPass make_paper_pass() {
  const auto lanes = std::make_shared<LanePass>();  // shared, as a FilterPass can be copied
  return [lanes](const PassInput& in) {
    if (in.parameters.arithmetic == Arithmetic::reference)
      return PassOutput{paper_pass(in.mesh, in.position, in.normal, in.movable, in.parameters, in.job)};
    return lanes->run(in);
  };
}

FilterPass make_bmd_pass() { return bmd_pass; }
FilterPass make_jones_pass() { return jones_pass; }
FilterPass make_guided_pass() {
  return [](const PassInput& in) { return guided_pass(in); };
}

SmoothingParameters with_iterations(int iterations) {
  SmoothingParameters parameters;
  parameters.iterations = iterations;
  return parameters;
}

/// Borders are as noisy as the rest, and the guided filter does not pull them inwards.
SmoothingParameters guided_defaults() {
  SmoothingParameters parameters = with_iterations(0);
  parameters.boundary = Boundary::free;
  return parameters;
}

}  // namespace

// The parameters are Table 1's: for the three bilateral filters they are the defaults of SmoothingParameters.
const std::vector<FilterEntry>& filter_table() {
  static const std::vector<FilterEntry> table = {
      {{Method::paper,
        "paper",
        "Anisotropic feature-preserving smoothing",
        {"sigma_c", "sigma_s", "sigma_n", "rho", "iterations", "gaussian"},
        {}},
       true,
       make_paper_pass},
      {{Method::bmd, "bmd", "Bilateral mesh denoising", {"sigma_c", "sigma_s", "rho", "iterations", "gaussian"}, {}},
       true,
       make_bmd_pass},
      {{Method::jones,
        "jones",
        "Non-iterative feature-preserving smoothing",
        {"sigma_c", "sigma_s", "rho", "iterations"},
        {}},
       false,
       make_jones_pass},
      {{Method::laplacian, "laplacian", "Laplacian smoothing", {"iterations"}, with_iterations(20)},
       false,
       make_laplacian_pass},
      {{Method::hc, "hc", "Improved Laplacian smoothing (HC)", {"iterations"}, with_iterations(20)},
       false,
       make_hc_pass},
      {{Method::hc_vcglib,
        "hc_vcglib",
        "Improved Laplacian smoothing as vcglib has it, which shrinks",
        {"iterations"},
        with_iterations(20)},
       false,
       make_hc_vcglib_pass},
      {{Method::taubin, "taubin", "Taubin's signal processing", {"iterations"}, with_iterations(20)},
       false,
       make_taubin_pass},
      {{Method::guided,
        "guided",
        "Guided anisotropic smoothing",
        {"strength", "feature_angle", "iterations", "smooth_color"},
        guided_defaults(),
        0},
       false,
       make_guided_pass,
       true},
  };
  return table;
}

const FilterEntry& filter_entry(Method method) {
  const auto& table = filter_table();
  return *std::find_if(table.begin(), table.end(), [&](const FilterEntry& e) { return e.info.method == method; });
}

}  // namespace vcg_core::detail
