// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue.h"

#include <algorithm>

#include "filters/bmd/bmd_filter.h"
#include "filters/guided/guided_filter.h"
#include "filters/hc/hc_filter.h"
#include "filters/hc_vcglib/hc_vcglib_filter.h"
#include "filters/jones/jones_filter.h"
#include "filters/laplacian/laplacian_filter.h"
#include "filters/paper/paper_filter.h"
#include "filters/taubin/taubin_filter.h"

namespace vcg_core::detail {

const std::vector<Filter>& catalogue() {
  static const std::vector<Filter> filters = {paper_filter(), bmd_filter(),       jones_filter(),  laplacian_filter(),
                                              hc_filter(),    hc_vcglib_filter(), taubin_filter(), guided_filter()};
  return filters;
}

const Filter& filter_of(Method method) {
  const auto& filters = catalogue();
  return *std::find_if(filters.begin(), filters.end(), [&](const Filter& f) { return f.info.method == method; });
}

}  // namespace vcg_core::detail
