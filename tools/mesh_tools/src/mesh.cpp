// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace mesh_tools {

void Mesh::swap(Mesh& other) noexcept {  // vectors keep their storage when swapped, so references between elements hold
  vert.swap(other.vert);
  edge.swap(other.edge);
  face.swap(other.face);
  std::swap(vn, other.vn);
  std::swap(en, other.en);
  std::swap(fn, other.fn);
  std::swap(bbox, other.bbox);
  textures.swap(other.textures);
  normalmaps.swap(other.normalmaps);
}

double average_edge_length(const Mesh& mesh) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  edges.reserve(3 * mesh.face.size());
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = vcg::tri::Index(mesh, face.cV(k)), b = vcg::tri::Index(mesh, face.cV((k + 1) % 3));
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  double sum = 0;
  for (const auto& [a, b] : edges) sum += (mesh.vert[a].cP() - mesh.vert[b].cP()).Norm();
  return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

double signed_volume(const Mesh& mesh) {
  vcg::Point3d origin(0, 0, 0);  // near the mesh, so that no digits are lost far from the origin
  for (const auto& vertex : mesh.vert)
    if (!vertex.IsD()) {
      origin = vertex.cP();
      break;
    }
  double sum = 0;
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    const vcg::Point3d a = face.cP(0) - origin, b = face.cP(1) - origin, c = face.cP(2) - origin;
    sum += a * (b ^ c);
  }
  return sum / 6;
}

}  // namespace mesh_tools
