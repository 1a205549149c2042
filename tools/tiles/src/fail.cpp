// SPDX-License-Identifier: GPL-3.0-or-later
#include "fail.h"

#include <mesh_tools/mesh_io.h>

namespace tiles {

void fail(const std::filesystem::path& path, const std::string& what) {
  throw mesh_tools::FileError(path.string() + ": " + what);
}

}  // namespace tiles
