// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "families.h"
#include "patch.h"
#include "torus_layout.h"

namespace mesh_tools::shapes {

void make_torus(std::size_t vertices, Mesh& mesh) {
  const TorusLayout torus(vertices);
  std::vector<vcg::Point3d> points;
  std::vector<std::array<int, 3>> triangles;
  for (int row = 0; row < torus.rows; ++row)
    for (int column = 0; column < torus.columns; ++column) {
      const std::array<double, 3> p = torus.point(row, column);
      points.emplace_back(p[0], p[1], p[2]);
      for (const std::array<int, 3>& face : torus.faces(row, column)) triangles.push_back(face);
    }
  fill_mesh(points, triangles, mesh);
}

}  // namespace mesh_tools::shapes
