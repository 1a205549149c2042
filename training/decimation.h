// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

namespace training {

/// Collapses edges, by quadric error as MeshLab's filter does or at random, until this share of the faces is left:
/// uneven and long triangles.
void decimate(mesh_tools::Mesh& mesh, double share, mesh_tools::Random& random);

}  // namespace training
