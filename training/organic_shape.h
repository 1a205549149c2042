// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

namespace training {

/// A bent and bumpy ball, or a tube closed to a ring, with detail on several scales that differs from place to place,
/// and on some of them ridges that fade. 4,000 to 12,000 vertices.
mesh_tools::Mesh organic_shape(mesh_tools::Random& random);

}  // namespace training
