// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace anisosmooth {

/// Whether a program is on the PATH.
bool has_program(const std::string& name);

/// Runs a program in `folder`, with its output going to the file `log` there. The words of the command reach it as they
/// are: no shell takes them apart.
/// @param stop  asked often; true ends the program, and what it has started
/// @return  its exit status, or 128 + the signal that ended it
/// @throws std::runtime_error if it cannot be started or its status cannot be known
int run_program(const std::vector<std::string>& command, const std::filesystem::path& folder, const std::string& log,
                const std::function<bool()>& stop);

}  // namespace anisosmooth
