// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include <vcg_core/method.h>

namespace vcg_core {

/// For GoogleTest's messages, and for the names of tests.
inline void PrintTo(const MethodInfo& info, std::ostream* out) { *out << info.name; }

}  // namespace vcg_core
