// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <mesh_tools/mesh_io.h>

namespace mesh_tools {

/// The numbers that a PLY file holds for its vertices under that name, one for each.
/// @throws FileError: it is no PLY file, or has no such property of single numbers
std::vector<double> vertex_property(const OriginalFile& file, const std::string& name);

}  // namespace mesh_tools
