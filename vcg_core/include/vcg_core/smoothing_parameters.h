// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/filters/common_parameters.h>
#include <vcg_core/filters/guided_parameters.h>
#include <vcg_core/filters/paper_parameters.h>

namespace vcg_core {

enum class Method;

/// Parameters of all filters together, for callers that choose the filter at run time; each filter reads its own part,
/// and what it does not know has no effect. What the parameters mean stands in the tables of the headers above, which
/// method_info() hands out. Lengths are in multiples of |e|, the average length of the mesh's unique edges.
///
/// The defaults are those of the paper's filter, from its Table 1; MethodInfo::defaults has those of each filter.
struct SmoothingParameters : CommonParameters, PaperParameters, GuidedParameters {
  /// @throws InvalidParameter with the name, the value and the allowed range of the first parameter of this method that
  ///         is out of range or not finite
  void validate(Method method) const;
};

}  // namespace vcg_core
