// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// A mesh without noise, as CAD systems tessellate and modellers build them: coarse, with long thin triangles, fans and
/// fine parts beside large ones. A filter that removes noise has nothing to do on it.
struct CleanShape {
  std::string name;
  FlatMesh mesh;
};

/// All of them, each also with every triangle split in four at the middles of its edges.
std::vector<CleanShape> clean_shapes();

/// For GoogleTest's messages.
inline std::ostream& operator<<(std::ostream& out, const CleanShape& shape) { return out << shape.name; }

/// Each triangle split in four at the middles of its edges; the surface stays the same.
FlatMesh split_in_four(const FlatMesh& mesh);

/// Prism of height 1 over a star-shaped outline around the z axis, given as points in the plane, anticlockwise. Walls
/// of two triangles a side.
/// @param fan  caps are fans around a vertex in their middle; else around the outline's first vertex, as ear clipping
///             leaves a convex outline
FlatMesh prism(const std::vector<Point>& outline, bool fan);

/// Regular polygon of radius 1.
std::vector<Point> polygon(std::size_t sides);

/// Radius 1 in the z = 0 plane, tip at height 2; closed by a fan.
FlatMesh cone(std::size_t sides);

/// Square plate of half width 5 and height 1 with a round hole of radius 1, finely cut: `sides` (a multiple of four) by
/// `rows` on its wall, long triangles from its rims to the corners.
FlatMesh plate_with_fine_hole(std::size_t sides, std::size_t rows);

/// Surface of revolution around the z axis through the points (radius, height), `sides` to a ring; closed at both ends
/// by fans.
FlatMesh lathe(const std::vector<std::pair<double, double>>& profile, std::size_t sides);

}  // namespace test_support
