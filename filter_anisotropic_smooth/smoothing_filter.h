// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter.h"

#include <vcg_core/method.h>

namespace meshlab_plugin {

/// A smoothing filter of the core: method, texts, and the parameters that its table has for a dialog.
Filter smoothing_filter(vcg_core::Method method, const char* name, const char* python_name, const char* help);

}  // namespace meshlab_plugin
