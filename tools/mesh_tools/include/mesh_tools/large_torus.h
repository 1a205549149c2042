// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

namespace mesh_tools {

struct LargeTorus {
  std::size_t vertices = 0, faces = 0;
};

/// Writes the torus of make_shape() to a binary PLY file as it is made, without ever holding it: the same bytes as
/// write_mesh() gives, in a few megabytes of memory. The file appears complete or not at all.
/// @param interrupted  asked often; true: stop, leave nothing
/// @throws FileError, WriteInterrupted
LargeTorus write_large_torus(std::size_t vertices, bool in_double, const std::filesystem::path& path,
                             const std::function<bool()>& interrupted = {});

}  // namespace mesh_tools
