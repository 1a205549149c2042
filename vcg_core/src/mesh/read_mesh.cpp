// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/read_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <vcg_core/errors.h>

#include "job.h"
#include "mesh/rows.h"
#include "power_of_two.h"

namespace vcg_core::detail {

namespace {

constexpr Index deleted_vertex = std::numeric_limits<Index>::max();

/// Between 2^-this and 2^this, coordinates are taken as they are: fourth powers of edges a thousand million times
/// shorter are numbers still.
constexpr int usual_exponent = 64;

double weight_at(const MeshView& view, std::size_t v) {
  const double weight = load_real(view.weights, v);
  if (!(weight >= 0 && weight <= 1))
    throw InvalidParameter("the weight of vertex " + std::to_string(v) + " is " + std::to_string(weight) +
                           "; allowed is 0 to 1");
  return weight;
}

/// Copies the vertices that are not deleted, and checks them.
/// @return index into raw.position of each of the caller's vertices, or deleted_vertex
Array<Index> read_vertices(const MeshView& view, RawMesh& raw, Job& job) {
  Array<Index> index_of(view.vertices);
  raw.host_vertex_count = view.vertices;
  raw.coordinate_epsilon = view.positions.type == RealType::float32 ? std::numeric_limits<float>::epsilon()
                                                                    : std::numeric_limits<double>::epsilon();
  raw.position.reserve(view.vertices);
  raw.host_vertex.reserve(view.vertices);
  const bool may_be_selected = view.selected_vertices || view.selected_faces;
  if (may_be_selected) raw.selected.reserve(view.vertices);
  if (view.weights) raw.weight.reserve(view.vertices);
  if (view.counted_vertices) raw.counted_copies.reserve(view.vertices);
  std::size_t not_finite = 0;
  std::size_t first_not_finite = view.vertices;
  double largest = 0;
  for (std::size_t v = 0; v < view.vertices; ++v) {
    if (v % 65536 == 0) job.report(0.0);
    index_of[v] = is_set(view.deleted_vertices, v) ? deleted_vertex : static_cast<Index>(raw.position.size());
    if (index_of[v] == deleted_vertex) continue;
    const Vec3 position = load_point(view.positions, v);
    if (!position.allFinite()) {
      ++not_finite;
      first_not_finite = std::min(first_not_finite, v);
    }
    largest = std::max(largest, position.cwiseAbs().maxCoeff());
    raw.position.push_back(position);
    raw.host_vertex.push_back(static_cast<Index>(v));
    if (may_be_selected) raw.selected.push_back(is_set(view.selected_vertices, v));
    if (view.weights) raw.weight.push_back(weight_at(view, v));
    if (view.counted_vertices) raw.counted_copies.push_back(is_set(view.counted_vertices, v));
  }
  if (not_finite > 0)
    throw InvalidMesh(std::to_string(not_finite) + (not_finite == 1 ? " vertex has" : " vertices have") +
                      " a coordinate that is not a finite number, the first is vertex " +
                      std::to_string(first_not_finite));
  if (largest > 0 && std::abs(std::ilogb(largest)) > usual_exponent) {
    raw.exponent = -std::ilogb(largest);
    const PowerOfTwo scale(raw.exponent);
    job.serial(raw.position.size(), [&](std::size_t i) { raw.position[i] = scale * raw.position[i]; });
  }
  return index_of;
}

/// Copies the faces that are not deleted, and checks them.
void read_faces(const MeshView& view, const Array<Index>& index_of, RawMesh& raw, Job& job) {
  raw.face.reserve(view.faces);
  for (std::size_t f = 0; f < view.faces; ++f) {
    if (f % 65536 == 0) job.report(0.0);
    if (is_set(view.deleted_faces, f)) continue;
    std::array<Index, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = load_index(view.triangles, f, k);
      if (v >= index_of.size() || index_of[v] == deleted_vertex)
        throw InvalidMesh("face " + std::to_string(f) + " refers to a vertex that the mesh does not have");
      triangle[k] = index_of[v];
    }
    if (is_set(view.selected_faces, f))
      for (const Index v : triangle) raw.selected[v] = 1;
    raw.face.push_back(triangle);
    if (view.counted_faces) raw.counted_face.push_back(is_set(view.counted_faces, f));
  }
}

/// Copies the creases, and checks them.
void read_creases(const MeshView& view, const Array<Index>& index_of, RawMesh& raw, Job& job) {
  raw.crease_ends.reserve(view.crease_count);
  job.serial(view.crease_count, [&](std::size_t i) {
    std::array<Index, 2> ends;
    for (int k = 0; k < 2; ++k) {
      const std::size_t v = load_index(view.creases, i, k);
      if (v >= index_of.size() || index_of[v] == deleted_vertex)
        throw InvalidMesh("crease " + std::to_string(i) + " refers to a vertex that the mesh does not have");
      ends[static_cast<std::size_t>(k)] = index_of[v];
    }
    raw.crease_ends.push_back(ends);
  });
}

/// @param exponent  RawMesh::exponent
std::optional<WholeMesh> scaled(std::optional<WholeMesh> whole, int exponent) {
  if (!whole) return whole;
  const PowerOfTwo scale(exponent);
  whole->average_edge_length = scale * whole->average_edge_length;
  for (int k = 0; k < 3; ++k) {
    whole->box_min[k] = scale * whole->box_min[k];
    whole->box_max[k] = scale * whole->box_max[k];
  }
  if (!whole->guided) return whole;
  whole->guided->noise = scale * whole->guided->noise;
  whole->guided->testimony.opposed = scale * (scale * whole->guided->testimony.opposed);
  if (!whole->guided->grid) return whole;
  for (int k = 0; k < 3; ++k) {
    whole->guided->grid->first[k] = scale * whole->guided->grid->first[k];
    whole->guided->grid->distance[k] = scale * whole->guided->grid->distance[k];
  }
  return whole;
}

void require_faces(std::size_t faces) {
  if (faces == 0) throw InvalidMesh("the mesh has no faces; this filter needs a triangle mesh");
}

}  // namespace

MeshArrays read_mesh(const MeshView& view, Job& job, ReadOptions options) {
  job.begin_stage("Reading the mesh", 0.05);
  require_faces(view.faces);
  require_countable(view.vertices, view.faces);
  if ((view.vertices > 0 && !view.positions) || !view.triangles || (view.crease_count > 0 && !view.creases))
    throw InvalidMesh("the view counts elements that it has no memory of");
  RawMesh raw;
  {
    const Array<Index> index_of = read_vertices(view, raw, job);
    read_faces(view, index_of, raw, job);
    require_faces(raw.face.size());
    read_creases(view, index_of, raw, job);
  }
  raw.whole = scaled(view.whole, raw.exponent);
  options.weld_distance = PowerOfTwo(raw.exponent) * options.weld_distance;
  return make_mesh_arrays(std::move(raw), job, options);
}

}  // namespace vcg_core::detail
