#include <mesh_tools/mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace mesh_tools {
namespace {

template <class From, class To>
void copy_elements(const From& from, To& to) {
  using Allocator = vcg::tri::Allocator<To>;
  using Scalar = typename To::ScalarType;
  to.Clear();
  std::vector<std::size_t> index(from.vert.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < from.vert.size(); ++i)
    if (!from.vert[i].IsD()) index[i] = count++;
  if (count > 0) Allocator::AddVertices(to, count);
  auto vertex = to.vert.begin();
  for (const auto& source : from.vert) {
    if (source.IsD()) continue;
    vertex->P().Import(source.cP());
    vertex->N().Import(source.cN());
    vertex->Flags() = source.cFlags();
    vertex->C() = source.cC();
    vertex->Q() = static_cast<Scalar>(source.cQ());
    vertex->T() = source.cT();
    vertex->R() = source.cR();
    ++vertex;
  }
  const auto reference = [&](const auto* v) { return &to.vert[index[v - from.vert.data()]]; };
  for (const auto& source : from.edge) {
    if (source.IsD()) continue;
    auto& edge = *Allocator::AddEdges(to, 1);
    for (int k = 0; k < 2; ++k) edge.V(k) = reference(source.cV(k));
  }
  const std::size_t faces = std::count_if(from.face.begin(), from.face.end(), [](const auto& f) { return !f.IsD(); });
  if (faces > 0) Allocator::AddFaces(to, faces);
  auto face = to.face.begin();
  for (const auto& source : from.face) {
    if (source.IsD()) continue;
    for (int k = 0; k < 3; ++k) {
      face->V(k) = reference(source.cV(k));
      face->WT(k) = source.cWT(k);
    }
    face->N().Import(source.cN());
    face->Flags() = source.cFlags();
    face->C() = source.cC();
    face->Q() = static_cast<Scalar>(source.cQ());
    ++face;
  }
  to.textures = from.textures;
  to.normalmaps = from.normalmaps;
  to.bbox.Import(from.bbox);
}

}  // namespace

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

void convert(const MeshF& from, Mesh& to) { copy_elements(from, to); }
void convert(const Mesh& from, MeshF& to) { copy_elements(from, to); }

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
