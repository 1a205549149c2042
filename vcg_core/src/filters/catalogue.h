#pragma once

#include <vector>

#include <vcg_core/method.h>

#include "filters/filter.h"

namespace vcg_core::detail {

/// A method and the code behind it. This table is the one place that knows all methods.
struct FilterEntry {
  MethodInfo info;
  bool needs_normals;         ///< whether PassInput::normal is wanted; vertices without a normal then stay in place
  FilterPass (*make_pass)();  ///< a fresh pass for a run over one mesh
  bool one_pass = false;      ///< whether parameters.iterations is the filter's own affair
};

const std::vector<FilterEntry>& filter_table();

const FilterEntry& filter_entry(Method method);

}  // namespace vcg_core::detail
