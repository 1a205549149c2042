// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include "terminal.h"

namespace anisosmooth {

bool stderr_is_terminal() { return ::isatty(STDERR_FILENO) != 0; }

}  // namespace anisosmooth
