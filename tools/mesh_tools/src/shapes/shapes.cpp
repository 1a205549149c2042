// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/shapes.h>

#include <algorithm>
#include <stdexcept>

#include <mesh_tools/voxel_shapes.h>

#include "families.h"

namespace mesh_tools {

const std::vector<Shape>& all_shapes() {
  using namespace mesh_tools::shapes;
  static const std::vector<Shape> table = {
      {"plane_slash", "square grid of the unit square, diagonals '/'", 4, make_plane_slash, false},
      {"plane_backslash", "the same, diagonals '\\'", 4, make_plane_backslash, false},
      {"plane_alternating", "the same, diagonals alternating", 4, make_plane_alternating, false},
      {"plane_random_diagonals", "the same, each diagonal drawn by lot", 4, make_plane_random_diagonals, false},
      {"plane_delaunay", "Delaunay triangulation of uniformly random points in the unit square", 4, make_plane_delaunay,
       false},
      {"sphere", "unit sphere, nearly uniform triangles", 12, make_sphere, true},
      {"torus", "torus of radii 1 and 0.4", 48, make_torus, true},
      {"cube", "unit cube, irregular triangles", 60, make_cube, true},
      {"stepped_block", "block with four steps", 200, make_stepped_block, true},
      {"cad_part",
       "machine part in the manner of a fan disk: straight and curved sharp edges, cylinders, fillets, a hole", 2000,
       make_cad_part, true},
      {"thin_plate", "closed square plate, one edge length thick", 100, make_thin_plate, true},
      {"thin_sheets", "four open square sheets of the same orientation, two edge lengths apart", 100, make_thin_sheets,
       false},
      {"graded_cube", "unit cube whose edges grow tenfold from one corner to the opposite one", 500, make_graded_cube,
       true},
  };
  return table;
}

Mesh make_shape(const std::string& name, std::size_t vertices) {
  if (is_voxel_shape(name)) return make_voxel_shape(name, vertices).surface;
  std::string wanted = name;
  std::replace(wanted.begin(), wanted.end(), '-', '_');
  std::string known;
  for (const Shape& shape : all_shapes()) {
    if (shape.name == wanted) {
      Mesh mesh;
      shape.make(std::max(vertices, shape.fewest_vertices), mesh);
      return mesh;
    }
    known += known.empty() ? shape.name : std::string(", ") + shape.name;
  }
  throw std::invalid_argument("unknown shape '" + name + "'; there are " + known + ", and voxel_ before a closed one");
}

}  // namespace mesh_tools
