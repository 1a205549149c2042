#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <vcg_core/detail/job.h>
#include <vcg_core/detail/mesh_arrays.h>
#include <vcg_core/detail/power_of_two.h>
#include <vcg_core/errors.h>

// Four headers know the caller's vcglib mesh: this one, commit_positions.h, vertex_attributes.h and distance_colors.h.
// All the rest works on plain arrays.

namespace vcg_core::detail {

constexpr Index deleted_vertex = std::numeric_limits<Index>::max();

/// Copies the vertices that are not deleted, and checks them.
/// @return index into raw.position of each element of mesh.vert, or deleted_vertex
template <class Mesh>
Array<Index> read_vertices(const Mesh& mesh, RawMesh& raw, Job& job) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  Array<Index> index_of(mesh.vert.size());
  raw.host_vertex_count = mesh.vert.size();
  raw.coordinate_epsilon = static_cast<double>(std::numeric_limits<typename Mesh::ScalarType>::epsilon());
  raw.position.reserve(mesh.vn);
  raw.host_vertex.reserve(mesh.vn);
  raw.selected.reserve(mesh.vn);
  std::size_t not_finite = 0;
  std::size_t first_not_finite = none;
  double largest = 0;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    if (v % 65536 == 0) job.report(0.0);
    index_of[v] = mesh.vert[v].IsD() ? deleted_vertex : static_cast<Index>(raw.position.size());
    if (index_of[v] == deleted_vertex) continue;
    const auto& p = mesh.vert[v].cP();
    const Vec3 position(p[0], p[1], p[2]);
    if (!position.allFinite()) {
      ++not_finite;
      first_not_finite = std::min(first_not_finite, v);
    }
    largest = std::max(largest, position.cwiseAbs().maxCoeff());
    raw.position.push_back(position);
    raw.host_vertex.push_back(static_cast<Index>(v));
    raw.selected.push_back(mesh.vert[v].IsS());
  }
  if (not_finite > 0)
    throw InvalidMesh(std::to_string(not_finite) + (not_finite == 1 ? " vertex has" : " vertices have") +
                      " a coordinate that is not a finite number, the first is vertex " +
                      std::to_string(first_not_finite));
  if (largest > 0) raw.exponent = -std::ilogb(largest);
  if (raw.exponent != 0) {
    const PowerOfTwo scale(raw.exponent);
    job.serial(raw.position.size(), [&](std::size_t i) { raw.position[i] = scale * raw.position[i]; });
  }
  return index_of;
}

/// Copies the faces that are not deleted, and checks them.
template <class Mesh>
void read_faces(const Mesh& mesh, const Array<Index>& index_of, RawMesh& raw, Job& job) {
  raw.face.reserve(mesh.fn);
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    if (f % 65536 == 0) job.report(0.0);
    const auto& face = mesh.face[f];
    if (face.IsD()) continue;
    std::array<Index, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      // Compared as addresses: a pointer into another array has no difference to subtract.
      const auto address = reinterpret_cast<std::uintptr_t>(face.cV(k));
      const auto first = reinterpret_cast<std::uintptr_t>(mesh.vert.data());
      const std::size_t v = (address - first) / sizeof(mesh.vert[0]);
      if (address < first || v >= index_of.size() || index_of[v] == deleted_vertex)
        throw InvalidMesh("face " + std::to_string(f) + " refers to a vertex that the mesh does not have");
      triangle[k] = index_of[v];
      if (face.IsS()) raw.selected[index_of[v]] = 1;
    }
    raw.face.push_back(triangle);
  }
}

/// Copies any vcglib triangle mesh. Throws InvalidMesh: no faces, too many vertices or faces, a coordinate that is not
/// finite (with count and first index), a face that refers to no vertex of the mesh, no edge of any length.
template <class Mesh>
MeshArrays read_mesh(const Mesh& mesh, Job& job) {
  job.begin_stage("Reading the mesh", 0.05);
  if (mesh.fn <= 0) throw InvalidMesh("the mesh has no faces; this filter needs a triangle mesh");
  require_countable(mesh.vert.size(), mesh.face.size());
  RawMesh raw;
  const Array<Index> index_of = read_vertices(mesh, raw, job);
  read_faces(mesh, index_of, raw, job);
  return make_mesh_arrays(std::move(raw), job);
}

}  // namespace vcg_core::detail
