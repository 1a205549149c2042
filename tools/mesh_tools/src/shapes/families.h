// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <mesh_tools/mesh.h>

/// The shapes behind mesh_tools::all_shapes(); what each looks like stands in its table.
namespace mesh_tools::shapes {

void make_plane_slash(std::size_t vertices, Mesh& mesh);
void make_plane_backslash(std::size_t vertices, Mesh& mesh);
void make_plane_alternating(std::size_t vertices, Mesh& mesh);
void make_plane_random_diagonals(std::size_t vertices, Mesh& mesh);
void make_plane_delaunay(std::size_t vertices, Mesh& mesh);
void make_sphere(std::size_t vertices, Mesh& mesh);
void make_torus(std::size_t vertices, Mesh& mesh);
void make_cube(std::size_t vertices, Mesh& mesh);
void make_stepped_block(std::size_t vertices, Mesh& mesh);
void make_cad_part(std::size_t vertices, Mesh& mesh);
void make_thin_plate(std::size_t vertices, Mesh& mesh);
void make_thin_sheets(std::size_t vertices, Mesh& mesh);
void make_graded_cube(std::size_t vertices, Mesh& mesh);

}  // namespace mesh_tools::shapes
