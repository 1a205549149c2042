// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_arrays.h"

#include <algorithm>
#include <string>
#include <utility>

#include <vcg_core/errors.h>

#include "job.h"
#include "mesh/creases.h"
#include "mesh/weld.h"
#include "mesh_topology.h"
#include "spatial_order.h"
#include "volume.h"

namespace vcg_core::detail {

namespace {

void require_at_most(std::size_t most, std::size_t count, const char* elements) {
  if (count > most)
    throw InvalidMesh("the mesh has " + std::to_string(count) + " " + elements + "; at most " + std::to_string(most) +
                      " can be smoothed or measured in one piece");
}

/// Renames the vertices of faces or edges.
/// @param index_of  the new index of each vertex
template <std::size_t corners>
Array<std::array<Index, corners>> renamed(const Array<std::array<Index, corners>>& faces, const Array<Index>& index_of,
                                          Job& job) {
  Array<std::array<Index, corners>> result(faces.size());
  job.serial(faces.size(), [&](std::size_t f) {
    for (std::size_t k = 0; k < corners; ++k) result[f][k] = index_of[faces[f][k]];
  });
  return result;
}

/// Puts the faces in the order of their lowest vertex, by counting, and their corners' copies with them.
void sort_faces(MeshArrays& mesh, Job& job) {
  Array<Index> begin(mesh.size() + 1, 0);
  const auto lowest = [&](std::size_t f) { return std::min({mesh.face[f][0], mesh.face[f][1], mesh.face[f][2]}); };
  job.serial(mesh.face.size(), [&](std::size_t f) { ++begin[lowest(f) + 1]; });
  job.serial(mesh.size(), [&](std::size_t v) { begin[v + 1] += begin[v]; });
  Array<std::array<Index, 3>> face(mesh.face.size());
  Array<std::array<Index, 3>> corner_copy(mesh.corner_copy.size());
  Array<std::uint8_t> counted(mesh.counted_face.size());
  job.serial(mesh.face.size(), [&](std::size_t f) {
    const Index to = begin[lowest(f)]++;
    face[to] = mesh.face[f];
    if (!corner_copy.empty()) corner_copy[to] = mesh.corner_copy[f];
    if (!counted.empty()) counted[to] = mesh.counted_face[f];
  });
  mesh.face.swap(face);
  mesh.corner_copy.swap(corner_copy);
  mesh.counted_face.swap(counted);
}

}  // namespace

void require_countable(std::size_t vertices, std::size_t faces) {
  require_at_most(most_elements, vertices, "vertices");
  require_at_most(most_elements, faces, "faces");
}

MeshArrays make_mesh_arrays(RawMesh raw, Job& job, const ReadOptions& options) {
  MeshArrays mesh;
  static_cast<RawMesh&>(mesh) = std::move(raw);
  {
    const Array<Index> order = morton_order(mesh.position, box_of_whole(mesh, job), job).order;
    job.report(0.3);
    const Welding welding = weld(mesh.position, order, options.weld_distance, job);
    const Array<Index> by_vertex = reorder_vertices(mesh, order, welding, job);
    Array<Index> index_of(order.size());
    if (options.corner_copies && !mesh.copy_begin.empty()) {
      job.serial(order.size(), [&](std::size_t k) { index_of[by_vertex[k]] = static_cast<Index>(k); });
      mesh.corner_copy = renamed(mesh.face, index_of, job);
    }
    job.serial(order.size(), [&](std::size_t i) { index_of[order[i]] = welding.vertex[i]; });
    mesh.face = renamed(mesh.face, index_of, job);
    mesh.crease_ends = renamed(mesh.crease_ends, index_of, job);
    sort_faces(mesh, job);
    job.report(0.5);
  }
  if (!mesh.copy_begin.empty())
    job.serial(mesh.size(),
               [&](std::size_t v) { mesh.coincident_vertices += mesh.copies(v) > 1 ? mesh.counted(v) : 0; });
  mesh.topology = find_topology(mesh, job);
  find_creases(mesh, std::move(mesh.crease_ends), job);
  return mesh;
}

Array<Index> vertex_of_host(const MeshArrays& mesh) {
  Array<Index> result(mesh.host_vertex_count, static_cast<Index>(mesh.size()));
  for (std::size_t v = 0; v < mesh.size(); ++v)
    for (std::size_t k = mesh.first_copy(v); k < mesh.first_copy(v + 1); ++k)
      result[mesh.host_vertex[k]] = static_cast<Index>(v);
  return result;
}

}  // namespace vcg_core::detail
