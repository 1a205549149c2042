// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <mesh_tools/mesh_io.h>

namespace mesh_tools::io {

/// Notes that the last triangles of the mesh are a polygon, cut into a fan from its first corner.
/// @param corners  of the polygon; at least 3
void note_fan(std::size_t corners, FlatFile& file);

/// Cuts those polygons anew that fans do not suit, once all vertices are in their places.
void cut_polygons(FlatFile& file);

inline bool is_deleted(const FlatMesh& /*mesh*/, std::size_t /*face*/) { return false; }
inline bool is_deleted(const Mesh& mesh, std::size_t face) { return mesh.face[face].IsD(); }

/// Calls `visit` for each polygon and each triangle that is no part of one, in the order of the file.
/// @param file   a FlatFile or a MeshFile
/// @param visit  takes the index of the first triangle, and a range of corners, each as 3 * face + k
template <class File, class Visit>
void visit_polygons(const File& file, const Visit& visit) {
  const auto& [polygons, corners] = file.polygons;
  std::size_t polygon = 0;
  for (std::size_t f = 0; f < file.mesh.face.size();) {
    if (polygon == polygons.size() || f != polygons[polygon].first_face) {
      const auto corner = static_cast<std::uint32_t>(3 * f);
      const std::array<std::uint32_t, 3> triangle{corner, corner + 1, corner + 2};
      if (!is_deleted(file.mesh, f)) visit(f, triangle.data(), triangle.data() + 3);
      ++f;
      continue;
    }
    const std::size_t first = polygons[polygon].first_corner;
    const std::size_t last = ++polygon < polygons.size() ? polygons[polygon].first_corner : corners.size();
    visit(f, corners.data() + first, corners.data() + last);
    f += last - first - 2;
  }
}

/// Of polygons, and triangles that are no part of one.
struct PolygonCount {
  std::size_t count = 0, most_corners = 0;
};
PolygonCount count_polygons(const FlatFile& file);

}  // namespace mesh_tools::io
