// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace apply_mlx {

/// Loads the installed MeshLab's plugins and then `files`, whose filters come before others of the same name. A plugin
/// of MeshLab's own that does not load is left out, as in MeshLab.
/// @throws Failure if one of `files` does not load, or MeshLab has no plugins where they should be
void load_plugins(const std::vector<std::string>& files);

}  // namespace apply_mlx
