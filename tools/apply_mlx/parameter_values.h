// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDomElement>

#include <common/parameters/rich_parameter_list.h>

namespace apply_mlx {

/// Puts the values of a script in the place of a filter's defaults. What the script leaves out keeps its default.
/// Whether a value suits the filter is the filter's to say; here it must be of the parameter's type.
/// @throws Failure for a parameter that the filter does not have or that is given twice, and for a value of another
/// type
void set_values(const std::vector<QDomElement>& given, RichParameterList& parameters);

}  // namespace apply_mlx
