// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

namespace training {

/// A range image of a landscape of bumps, steps and folds, seen along z and cut where it drops too steeply, as scanners
/// deliver them.
mesh_tools::Mesh height_field(mesh_tools::Random& random);

}  // namespace training
