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

void to_single_precision(const Mesh& from, MeshF& to) {
  using Allocator = vcg::tri::Allocator<MeshF>;
  to.Clear();
  if (!from.vert.empty()) Allocator::AddVertices(to, from.vert.size());
  for (std::size_t i = 0; i < from.vert.size(); ++i) {
    const auto& source = from.vert[i];
    auto& vertex = to.vert[i];
    vertex.P().Import(source.cP());
    vertex.Flags() = source.cFlags();
    vertex.C() = source.cC();
    vertex.Q() = static_cast<float>(source.cQ());
  }
  if (!from.face.empty()) Allocator::AddFaces(to, from.face.size());
  for (std::size_t i = 0; i < from.face.size(); ++i) {
    for (int k = 0; k < 3; ++k) to.face[i].V(k) = &to.vert[vcg::tri::Index(from, from.face[i].cV(k))];
    to.face[i].Flags() = from.face[i].cFlags();
  }
  to.vn = from.vn;
  to.fn = from.fn;
}

void take_vertices(const MeshF& from, Mesh& to) {
  for (std::size_t i = 0; i < from.vert.size(); ++i) {
    to.vert[i].P().Import(from.vert[i].cP());
    to.vert[i].C() = from.vert[i].cC();
    to.vert[i].Q() = from.vert[i].cQ();
  }
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
