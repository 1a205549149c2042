// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// Flat disc of radius 1: `n` triangles around its middle.
FlatMesh fan(std::size_t n);

/// Closed cone of radius 1 and height `height`: `n` sides, a fan below.
FlatMesh cone(std::size_t n, double height);

/// Closed prism over a regular polygon of `n` corners, radius 1, height 1: two triangles a side, a fan on either end.
FlatMesh prism(std::size_t n);

/// The same with ends that are cut into triangles by clipping one ear after the other. `around_one_corner`: always the
/// next one to the same corner, which all triangles share in the end; otherwise every second corner in turn.
FlatMesh ear_clipped_prism(std::size_t n, bool around_one_corner);

/// An open umbrella of `n` ribs: the rim goes up and down, and in and out, from rib to rib.
FlatMesh umbrella(std::size_t n);

/// Sphere of `n` meridians and `rings` circles of latitude: two poles of `n` faces.
FlatMesh globe(std::size_t n, std::size_t rings);

/// All of these around vertices of about `n` faces, by name.
std::vector<std::pair<std::string, FlatMesh>> high_valence_meshes(std::size_t n);

}  // namespace test_support
