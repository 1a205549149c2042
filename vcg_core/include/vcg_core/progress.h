#pragma once

#include <functional>

namespace vcg_core {

/// Called during long work with the fraction done, in [0, 1] and never falling, and the name of the current stage.
/// It runs on the thread that called the library, at most about ten times a second. Returning false cancels: the
/// library throws `Cancelled` within 0.2 s and the mesh stays bit for bit as it was. An empty callable is allowed.
using Progress = std::function<bool(double fraction, const char* stage)>;

}  // namespace vcg_core
