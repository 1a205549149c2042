// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons.h"

#include <algorithm>
#include <vector>

#include "polygon.h"

namespace mesh_tools::io {
namespace {

/// Rewrites the triangles of a polygon, and which corners of them are its own.
void cut(FlatMesh& mesh, std::uint32_t first_face, std::uint32_t* corners,
         const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const bool textured = !mesh.wedge_texture.empty();
  std::vector<std::uint32_t> vertices;
  std::vector<FlatMesh::TextureCoordinate> places;
  for (std::size_t k = 0; k < triangles.size() + 2; ++k) {
    vertices.push_back(mesh.face[corners[k] / 3][corners[k] % 3]);
    if (textured) places.push_back(mesh.wedge_texture[corners[k] / 3][corners[k] % 3]);
  }
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = triangles[t][k];
      mesh.face[first_face + t][k] = vertices[corner];
      if (textured) mesh.wedge_texture[first_face + t][k] = places[corner];
      corners[corner] = 3 * (first_face + t) + k;
    }
}

}  // namespace

void note_fan(std::size_t corners, FlatFile& file) {
  if (corners == 3) return;
  auto face = static_cast<std::uint32_t>(file.mesh.face.size() - (corners - 2));
  file.polygons.polygons.push_back({face, static_cast<std::uint32_t>(file.polygons.corners.size())});
  file.polygons.corners.push_back(3 * face);
  file.polygons.corners.push_back(3 * face + 1);
  for (std::size_t k = 2; k < corners; ++k, ++face) file.polygons.corners.push_back(3 * face + 2);
}

void cut_polygons(FlatFile& file) {
  std::vector<vcg::Point3d> points;
  for (const Polygons::Polygon& polygon : file.polygons.polygons) {
    std::uint32_t* const corners = file.polygons.corners.data() + polygon.first_corner;
    const std::uint32_t* const end = &polygon == &file.polygons.polygons.back()
                                         ? file.polygons.corners.data() + file.polygons.corners.size()
                                         : file.polygons.corners.data() + (&polygon + 1)->first_corner;
    points.clear();
    for (const std::uint32_t* corner = corners; corner != end; ++corner)
      points.push_back(file.mesh.position[file.mesh.face[*corner / 3][*corner % 3]]);
    const auto triangles = triangulate(points);
    const bool is_fan = std::all_of(triangles.begin(), triangles.end(),
                                    [](const std::array<std::uint32_t, 3>& corner) { return corner[0] == 0; });
    if (!is_fan) cut(file.mesh, polygon.first_face, corners, triangles);
  }
}

PolygonCount count_polygons(const FlatFile& file) {
  PolygonCount result;
  visit_polygons(file, [&](std::size_t, const std::uint32_t* first, const std::uint32_t* last) {
    ++result.count;
    result.most_corners = std::max(result.most_corners, static_cast<std::size_t>(last - first));
  });
  return result;
}

}  // namespace mesh_tools::io
