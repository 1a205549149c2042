// SPDX-License-Identifier: GPL-3.0-or-later
#include <windows.h>

#include "terminal.h"

namespace anisosmooth {

bool stderr_is_terminal() {
  const HANDLE handle = ::GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  return ::GetConsoleMode(handle, &mode) != 0 && ::SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) !=
                                                     0;  // for the sequences that erase a line
}

}  // namespace anisosmooth
