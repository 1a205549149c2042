#include "filter_table.h"

#include <algorithm>

#include "paper_filter.h"

namespace vcg_core::detail {

namespace {

FilterPass make_paper_pass() {
  return [](const PassInput& in) {
    return PassOutput{paper_pass(in.mesh, in.position, in.normal, in.movable, in.parameters, in.job)};
  };
}

}  // namespace

const std::vector<FilterEntry>& filter_table() {
  static const std::vector<FilterEntry> table = {
      {{Method::paper,
        "paper",
        "Anisotropic feature-preserving smoothing",
        {"sigma_c", "sigma_s", "sigma_n", "rho", "iterations", "gaussian"},
        {}},
       true,
       make_paper_pass},
  };
  return table;
}

const FilterEntry& filter_entry(Method method) {
  const auto& table = filter_table();
  return *std::find_if(table.begin(), table.end(), [&](const FilterEntry& e) { return e.info.method == method; });
}

}  // namespace vcg_core::detail
