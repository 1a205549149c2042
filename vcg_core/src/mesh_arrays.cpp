#include <vcg_core/detail/mesh_arrays.h>

#include <algorithm>
#include <string>
#include <utility>

#include <vcg_core/detail/job.h>
#include <vcg_core/errors.h>

#include "mesh_topology.h"
#include "spatial_order.h"

namespace vcg_core::detail {

namespace {

void require_at_most(std::size_t most, std::size_t count, const char* elements) {
  if (count > most)
    throw InvalidMesh("the mesh has " + std::to_string(count) + " " + elements + "; at most " + std::to_string(most) +
                      " can be smoothed or measured in one piece");
}

template <class T>
void permute(Array<T>& values, const Array<Index>& order, Job& job) {
  Array<T> permuted(values.size());
  job.serial(order.size(), [&](std::size_t i) { permuted[i] = values[order[i]]; });
  values.swap(permuted);
}

/// Puts the faces in the order of their lowest vertex, by counting; renames their vertices first.
void permute_faces(Array<std::array<Index, 3>>& faces, const Array<Index>& order, Job& job) {
  Array<Index> new_index(order.size());
  job.serial(order.size(), [&](std::size_t i) { new_index[order[i]] = static_cast<Index>(i); });
  Array<Index> begin(order.size() + 1, 0);
  const auto lowest = [](const std::array<Index, 3>& f) { return std::min({f[0], f[1], f[2]}); };
  job.serial(faces.size(), [&](std::size_t f) {
    for (Index& v : faces[f]) v = new_index[v];
    ++begin[lowest(faces[f]) + 1];
  });
  job.serial(order.size(), [&](std::size_t i) { begin[i + 1] += begin[i]; });
  Array<std::array<Index, 3>> permuted(faces.size());
  job.serial(faces.size(), [&](std::size_t f) { permuted[begin[lowest(faces[f])]++] = faces[f]; });
  faces.swap(permuted);
}

}  // namespace

void require_countable(std::size_t vertices, std::size_t faces) {
  require_at_most(most_elements, vertices, "vertices");
  require_at_most(most_elements, faces, "faces");
}

MeshArrays make_mesh_arrays(RawMesh raw, Job& job) {
  MeshArrays mesh;
  static_cast<RawMesh&>(mesh) = std::move(raw);
  {
    const SpatialOrder spatial = morton_order(mesh.position, job);
    job.report(0.3);
    mesh.coincident_vertices = count_coincident(mesh.position, spatial, job);
    permute(mesh.position, spatial.order, job);
    permute(mesh.host_vertex, spatial.order, job);
    permute(mesh.selected, spatial.order, job);
    permute_faces(mesh.face, spatial.order, job);
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
