// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// Section 4.1 of the paper for one triangle: the distance of `apex`, given the distances `d_1` and `d_2` of its other
/// two vertices, by drawing the two circles in the triangle's plane, taking their far intersection and cutting the line
/// from there to the apex with the edge: three cases.
double naive_virtual_start(const Point& apex, const Point& v_1, double d_1, const Point& v_2, double d_2);

/// Distances from `source` along edges and by the three-case rule: all faces are swept again and again until none
/// improves a vertex by more than `gain` (a length). Vertices at the same place are one. Infinity where nothing leads.
/// Slow, and independent of the library's fast marching, its order of work and its cut-off.
/// @param reach  vertices farther than this pass nothing on, which saves time on large meshes
std::vector<double> naive_geodesics(const FlatMesh& mesh, std::size_t source, double gain,
                                    double reach = std::numeric_limits<double>::infinity());

}  // namespace test_support
