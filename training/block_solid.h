// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

namespace training {

/// Boxes put together and cut out of each other, meshed in unit steps, their vertices moved within the faces, and most
/// of them twisted, tapered, bent or sheared: machine parts with straight and curved edges and thin walls.
mesh_tools::Mesh block_solid(mesh_tools::Random& random);

}  // namespace training
