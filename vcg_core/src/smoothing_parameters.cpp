// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/smoothing_parameters.h>

#include <vcg_core/method.h>

namespace vcg_core {

void SmoothingParameters::validate(Method method) const {
  for (const ParameterInfo& row : method_info(method).parameters) row.require_valid(*this);
  for (const ParameterInfo& row : run_parameters<SmoothingParameters>()) row.require_valid(*this);
}

}  // namespace vcg_core
