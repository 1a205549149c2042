// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcglib_mesh.h"

#include <algorithm>
#include <array>

#include "polled_copy.h"

namespace vcg_core::detail {

namespace {

bool is_whole(const std::array<Index, 3>& f) { return f[0] != f[1] && f[1] != f[2] && f[2] != f[0]; }

/// Whether only one face has the edge that follows this corner.
bool is_border_edge(const MeshArrays& arrays, Index corner) {
  const MeshTopology& topology = arrays.topology;
  const Index from = vertex_of(arrays, corner);
  const Index to = vertex_of(arrays, next_in_face(corner));
  if (!topology.border[from] || !topology.border[to]) return false;
  int faces = 0;
  for (Index s = topology.star_begin[from]; s < topology.star_begin[from + 1]; ++s)
    faces += vertex_of(arrays, next_in_face(topology.star[s])) == to ||
             vertex_of(arrays, previous_in_face(topology.star[s])) == to;
  return faces == 1;
}

}  // namespace

VcglibMesh::VcglibMesh(const MeshArrays& arrays, Job& job) {
  const MeshTopology& topology = arrays.topology;
  Array<Index> index_of(arrays.size());
  job.serial(arrays.size(), [&](std::size_t v) {
    if (topology.star_begin[v] == topology.star_begin[v + 1]) return;
    index_of[v] = static_cast<Index>(vertex_.size());
    vertex_.push_back(static_cast<Index>(v));
  });
  vcg::tri::Allocator<SmoothedMesh>::AddVertices(mesh_, vertex_.size());
  job.poll();
  vcg::tri::Allocator<SmoothedMesh>::AddFaces(
      mesh_, static_cast<std::size_t>(std::count_if(arrays.face.begin(), arrays.face.end(), is_whole)));
  auto face = mesh_.face.begin();
  job.serial(arrays.face.size(), [&](std::size_t f) {
    if (!is_whole(arrays.face[f])) return;
    for (int k = 0; k < 3; ++k) {
      face->V(k) = &mesh_.vert[index_of[arrays.face[f][k]]];
      if (is_border_edge(arrays, static_cast<Index>(3 * f + k))) face->SetB(k);
    }
    ++face;
  });
  find_borders(job);
}

void VcglibMesh::find_borders(Job& job) {
  Array<Index> edges(mesh_.vert.size(), 0);
  job.serial(mesh_.face.size(), [&](std::size_t f) {
    const SmoothedFace& face = mesh_.face[f];
    for (int k = 0; k < 3; ++k)
      if (face.IsB(k))
        for (const int end : {k, (k + 1) % 3}) ++edges[vcg::tri::Index(mesh_, face.cV(end))];
  });
  job.serial(edges.size(), [&](std::size_t v) {
    if (edges[v] == 0) return;
    border_.push_back(static_cast<Index>(v));
    border_edges_.push_back(edges[v]);
  });
}

void VcglibMesh::load(const PassInput& in) {
  in.job.serial(vertex_.size(), [&](std::size_t v) {
    const Vec3& p = in.position[vertex_[v]];
    mesh_.vert[v].P() = vcg::Point3d(p[0], p[1], p[2]);
    if (in.movable[vertex_[v]])
      mesh_.vert[v].SetS();
    else
      mesh_.vert[v].ClearS();
  });
  has_movable_border_ = false;
  for (const Index v : border_) has_movable_border_ = has_movable_border_ || mesh_.vert[v].IsS();
}

Array<Vec3> VcglibMesh::positions(const PassInput& in) const {
  Array<Vec3> position = polled_copy(in.position, in.job);
  in.job.serial(vertex_.size(), [&](std::size_t v) {
    if (!mesh_.vert[v].IsS()) return;
    const vcg::Point3d& p = mesh_.vert[v].cP();
    position[vertex_[v]] = Vec3(p[0], p[1], p[2]);
  });
  return position;
}

}  // namespace vcg_core::detail
