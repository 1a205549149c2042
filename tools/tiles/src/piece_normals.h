// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "large_mesh.h"
#include "piece.h"

namespace tiles {

/// The normals that the vertices of a tile get, in the order of the file: as mesh_tools::write_moved() makes them. The
/// mean of the normals of the faces around, weighted by their angles; vertices at one place whose normals were equal
/// get one. A normal stays where no vertex of these faces has moved, and where they have no direction.
/// @param before  the positions of the piece, three numbers each
/// @param piece   after smoothing; right on the faces that touch the tile
std::vector<Point> moved_normals(const LargeMesh& mesh, const std::vector<double>& before, const Piece& piece);

}  // namespace tiles
