// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_compatibility.h"

#include <vcg_core/method.h>

namespace meshlab_plugin {

/// The parameters that the method's table has for a dialog, with the method's defaults. `mesh` may be null; it decides
/// whether only selected vertices are to move.
RichParameterList to_list(const vcg_core::MethodInfo& method, const MeshModel* mesh);

/// The method's defaults, replaced by the values of the dialog; what is allowed is the core's to check.
vcg_core::SmoothingParameters read_values(const vcg_core::MethodInfo& method, const RichParameterList& values);

}  // namespace meshlab_plugin
