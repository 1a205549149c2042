#include <vcg_core/detail/mesh_arrays.h>

#include <algorithm>
#include <utility>

#include <vcg_core/detail/job.h>

#include "mesh_topology.h"
#include "spatial_order.h"

namespace vcg_core::detail {

namespace {

template <class T>
void permute(Array<T>& values, const Array<Index>& order) {
  Array<T> permuted(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) permuted[i] = values[order[i]];
  values.swap(permuted);
}

/// Puts the faces in the order of their lowest vertex, by counting; renames their vertices first.
void permute_faces(Array<std::array<Index, 3>>& faces, const Array<Index>& order) {
  Array<Index> new_index(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) new_index[order[i]] = static_cast<Index>(i);
  Array<Index> begin(order.size() + 1, 0);
  const auto lowest = [](const std::array<Index, 3>& f) { return std::min({f[0], f[1], f[2]}); };
  for (auto& face : faces) {
    for (Index& v : face) v = new_index[v];
    ++begin[lowest(face) + 1];
  }
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  Array<std::array<Index, 3>> permuted(faces.size());
  for (const auto& face : faces) permuted[begin[lowest(face)]++] = face;
  faces.swap(permuted);
}

}  // namespace

MeshArrays make_mesh_arrays(RawMesh raw, Job& job) {
  MeshArrays mesh;
  static_cast<RawMesh&>(mesh) = std::move(raw);
  {
    const SpatialOrder spatial = morton_order(mesh.position);
    job.report(0.3);
    mesh.coincident_vertices = count_coincident(mesh.position, spatial);
    permute(mesh.position, spatial.order);
    permute(mesh.host_vertex, spatial.order);
    permute(mesh.selected, spatial.order);
    permute_faces(mesh.face, spatial.order);
    job.report(0.5);
  }
  mesh.topology = find_topology(mesh, job);
  return mesh;
}

Array<Index> vertex_of_host(const MeshArrays& mesh) {
  Array<Index> result(mesh.host_vertex_count, static_cast<Index>(mesh.size()));
  for (std::size_t i = 0; i < mesh.size(); ++i) result[mesh.host_vertex[i]] = static_cast<Index>(i);
  return result;
}

}  // namespace vcg_core::detail
