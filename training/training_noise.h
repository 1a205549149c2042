// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

namespace training {

/// Adds noise of some kind and level: along normals, in any direction, correlated over some edges, of a depth camera,
/// impulsive, or differing over the mesh.
void add_some_noise(mesh_tools::Mesh& mesh, mesh_tools::Random& random);

}  // namespace training
