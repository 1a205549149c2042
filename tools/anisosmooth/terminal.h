// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace anisosmooth {

/// Whether stderr is a terminal on which a line can be written anew: terminal_posix.cpp and terminal_windows.cpp.
bool stderr_is_terminal();

}  // namespace anisosmooth
