// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <mesh_tools/mesh.h>

namespace mesh_tools {

/// A shape that can be generated. All lie near the unit box and are the same on every call and platform.
struct Shape {
  const char* name;
  const char* description;
  std::size_t fewest_vertices;  ///< fewer are raised to this
  void (*make)(std::size_t vertices, Mesh& mesh);
  bool is_closed;
};

/// All shapes, in the order of the help text.
const std::vector<Shape>& all_shapes();

/// Generates a shape with about `vertices` vertices (within 5 % from some hundreds on).
/// @param name  as listed by all_shapes(), or "voxel_" before a closed one of them for the surface of its voxels
///              (voxel_shapes.h); '-' and '_' are the same
/// @throws std::invalid_argument naming the shapes there are
Mesh make_shape(const std::string& name, std::size_t vertices);

}  // namespace mesh_tools
