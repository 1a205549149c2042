// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <support/flat_mesh.h>

namespace test_support {

/// Unit cube around the origin, 8 vertices, 12 faces, looking outwards. Each vertex normal is along its diagonal.
FlatMesh cube();

/// Regular octahedron with vertices at distance 1 from the origin, looking outwards.
FlatMesh octahedron();

/// Unit sphere: the icosahedron, each face split in four `levels` times: 10 * 4^levels + 2 vertices.
FlatMesh icosphere(int levels);

/// side x side vertices of the unit square in z = 0, looking up, diagonals '/'. Vertex y * side + x lies at (x, y).
FlatMesh grid(std::size_t side);

/// The grid with heights z = height(x, y).
template <class Height>
FlatMesh height_field(std::size_t side, const Height& height) {
  return transformed(grid(side), [&](const Point& p) { return Point(p[0], p[1], height(p[0], p[1])); });
}

/// A closed, bumpy surface without symmetry: no two distances are equal by construction. 10 * 4^levels + 2 vertices.
FlatMesh potato(int levels);

}  // namespace test_support
