// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/mesh/measures.h>

#include <cmath>

#include "count_intersections.h"
#include "filters/guided/correlated_noise.h"
#include "filters/guided/noise_estimate.h"
#include "geodesic_field.h"
#include "job.h"
#include "mesh/read_mesh.h"
#include "vertex_normals.h"
#include "volume.h"

namespace vcg_core {

namespace {

constexpr const char* measuring = "Measuring the mesh";

}  // namespace

MeshSummary summarize(const MeshView& view, const Progress& progress) {
  detail::Job job(progress);
  const detail::MeshArrays mesh = detail::read_mesh(view, job);
  job.begin_stage(measuring, 1);
  const detail::MeshTopology& topology = mesh.topology;
  MeshSummary summary;
  summary.vertices = mesh.counted_vertices();
  summary.faces = mesh.counted_faces();
  job.serial(mesh.size(), [&](std::size_t v) {
    if (topology.star_begin[v] == topology.star_begin[v + 1]) summary.isolated_vertices += mesh.counted(v);
  });
  summary.border_vertices = topology.border_vertices;
  summary.non_manifold_vertices = topology.non_manifold_vertices;
  summary.coincident_vertices = mesh.coincident_vertices;
  summary.degenerate_faces = topology.degenerate_faces;
  summary.edges = topology.edges;
  summary.average_edge_length = std::ldexp(topology.own_edge_length, -mesh.exponent);
  summary.volume = detail::volume_over_center(mesh, mesh.position, job);
  job.finish();
  return summary;
}

std::vector<std::array<double, 3>> vertex_normals(const MeshView& view, const Progress& progress, int threads) {
  detail::Job job(progress, threads);
  const detail::MeshArrays mesh = detail::read_mesh(view, job);
  job.begin_stage(measuring, 1);
  const detail::Array<detail::Vec3> normal = detail::vertex_normals(mesh, mesh.position, job);
  std::vector<std::array<double, 3>> result(mesh.host_vertex_count, std::array<double, 3>{});
  job.serial(mesh.size(), [&](std::size_t v) {
    for (std::size_t k = mesh.first_copy(v); k < mesh.first_copy(v + 1); ++k)
      result[mesh.host_vertex[k]] = {normal[v][0], normal[v][1], normal[v][2]};
  });
  job.finish();
  return result;
}

double estimate_noise(const MeshView& view, const Progress& progress, int threads) {
  detail::Job job(progress, threads);
  const detail::MeshArrays mesh = detail::read_mesh(view, job);
  job.begin_stage(measuring, 1);
  double noise = detail::estimate_noise(mesh, detail::RingMeans(mesh, job), mesh.position, job).mean;
  if (!(noise > 0)) noise = detail::correlated_noise_of(mesh, job);
  job.finish();
  return std::ldexp(noise, -mesh.exponent);
}

std::vector<double> geodesic_distances(const MeshView& view, std::size_t source, const Progress& progress) {
  detail::Job job(progress);
  const detail::MeshArrays mesh = detail::read_mesh(view, job);
  return detail::geodesic_field(mesh, source, job);
}

std::size_t count_self_intersections(const MeshView& view, const Progress& progress, int threads) {
  detail::Job job(progress, threads);
  const detail::MeshArrays mesh = detail::read_mesh(view, job);
  job.begin_stage("Looking for self-intersections", 1);
  return detail::count_self_intersections(mesh, mesh.position, job);
}

}  // namespace vcg_core
