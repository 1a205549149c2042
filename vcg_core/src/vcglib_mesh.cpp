#include "vcglib_mesh.h"

#include <vcg/complex/algorithms/update/flag.h>

namespace vcg_core::detail {

VcglibMesh::VcglibMesh(const MeshArrays& arrays) {
  const MeshTopology& topology = arrays.topology;
  std::vector<Index> index_of(arrays.size());
  for (Index v = 0; v < arrays.size(); ++v) {
    if (topology.star_begin[v] == topology.star_begin[v + 1]) continue;
    index_of[v] = static_cast<Index>(vertex_.size());
    vertex_.push_back(v);
  }
  vcg::tri::Allocator<SmoothedMesh>::AddVertices(mesh_, vertex_.size());
  for (const auto& f : arrays.face)
    if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0])
      vcg::tri::Allocator<SmoothedMesh>::AddFace(mesh_, index_of[f[0]], index_of[f[1]], index_of[f[2]]);
  vcg::tri::UpdateFlags<SmoothedMesh>::FaceBorderFromNone(mesh_);
  find_borders();
}

void VcglibMesh::find_borders() {
  std::vector<Index> edges(mesh_.vert.size(), 0);
  for (const SmoothedFace& face : mesh_.face)
    for (int k = 0; k < 3; ++k)
      if (face.IsB(k))
        for (const int end : {k, (k + 1) % 3}) ++edges[vcg::tri::Index(mesh_, face.cV(end))];
  for (Index v = 0; v < edges.size(); ++v)
    if (edges[v] > 0) {
      border_.push_back(v);
      border_edges_.push_back(edges[v]);
    }
}

void VcglibMesh::load(const PassInput& in) {
  for (std::size_t v = 0; v < vertex_.size(); ++v) {
    const Vec3& p = in.position[vertex_[v]];
    mesh_.vert[v].P() = vcg::Point3d(p[0], p[1], p[2]);
    if (in.movable[vertex_[v]])
      mesh_.vert[v].SetS();
    else
      mesh_.vert[v].ClearS();
  }
  has_movable_border_ = false;
  for (const Index v : border_) has_movable_border_ = has_movable_border_ || mesh_.vert[v].IsS();
}

std::vector<Vec3> VcglibMesh::positions(const PassInput& in) const {
  std::vector<Vec3> position = in.position;
  for (std::size_t v = 0; v < vertex_.size(); ++v) {
    if (!mesh_.vert[v].IsS()) continue;
    const vcg::Point3d& p = mesh_.vert[v].cP();
    position[vertex_[v]] = Vec3(p[0], p[1], p[2]);
  }
  return position;
}

}  // namespace vcg_core::detail
