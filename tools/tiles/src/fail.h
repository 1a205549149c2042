// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tiles {

/// Throws mesh_tools::FileError, "FILE: what". (Its header brings vcglib along, which takes long to compile.)
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what);

}  // namespace tiles
