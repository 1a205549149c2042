// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// Names of all shapes that the tools generate.
std::vector<std::string> shape_names();

/// A shape with about `vertices` vertices, or the fewest that it can have, moved at random along the normals by
/// `noise` |e|. Always the same.
FlatMesh noisy_shape(const std::string& name, std::size_t vertices, double noise = 0.2);

}  // namespace test_support
