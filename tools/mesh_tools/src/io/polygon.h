// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <vcg/space/point3.h>

namespace mesh_tools::io {

/// Cuts a polygon into triangles whose union it is. Where the triangles between its first corner and its other edges
/// all face the same side, as in every convex polygon, these are the result; otherwise ears are cut off (G. Meisters,
/// Polygons have ears, 1975), as seen along the polygon's normal. Holes that a bridge of two equal edges joins to the
/// rim are left open. The time is about linear in the number of corners; for contrived shapes it is quadratic.
/// @param corners  around the polygon, at least 3; not all in one plane, or not finite, does no harm
/// @return         as many triangles as corners less 2, as indices into `corners`, turned as the polygon is; each
///                 corner is in at least one of them
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<vcg::Point3d>& corners);

}  // namespace mesh_tools::io
