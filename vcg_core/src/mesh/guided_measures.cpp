// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/mesh/guided_measures.h>

#include <cmath>

#include <vcg_core/method.h>

#include "filters/guided/correlated_noise.h"
#include "filters/guided/guided_filter.h"
#include "filters/guided/noise_estimate.h"
#include "filters/guided/told_whole.h"
#include "filters/guided/voxel_stairs.h"
#include "held_vertices.h"
#include "job.h"
#include "mesh/read_mesh.h"

namespace vcg_core {

namespace {

constexpr const char* measuring = "Measuring the mesh";

std::vector<detail::Vec3> vectors(const std::vector<std::array<double, 3>>& rows) {
  std::vector<detail::Vec3> result;
  result.reserve(rows.size());
  for (const std::array<double, 3>& row : rows) result.emplace_back(row[0], row[1], row[2]);
  return result;
}

detail::MeshArrays read_told(const MeshView& view, detail::Job& job) {
  detail::MeshArrays mesh = detail::read_mesh(view, job);
  if (detail::told_whole(mesh) == nullptr) throw InvalidParameter("nothing is told of the whole mesh");
  return mesh;
}

}  // namespace

std::optional<VoxelGrid> find_voxel_grid(const VoxelGridSample& sample, double average_edge_length,
                                         const std::function<VoxelLevelCounts(const VoxelGrid&)>& count) {
  return detail::find_voxel_grid({vectors(sample.vertices), vectors(sample.normals)}, average_edge_length, count);
}

unsigned voxel_levels(const std::array<double, 3>& point, const VoxelGrid& grid) {
  return detail::parity_at(detail::Vec3(point[0], point[1], point[2]), grid);
}

NoiseOfPiece noise_of_piece(const MeshView& piece, const Progress& progress, int threads) {
  detail::Job job(progress, threads);
  const detail::MeshArrays mesh = read_told(piece, job);
  job.begin_stage(measuring, 1);
  const detail::NoiseSeen seen = detail::look_for_noise(mesh, detail::RingMeans(mesh, job), mesh.position, job);
  NoiseOfPiece noise{seen.testimony, {}};
  noise.testimony.opposed = std::ldexp(noise.testimony.opposed, -2 * mesh.exponent);
  const double square = mesh.topology.average_edge_length * mesh.topology.average_edge_length;
  job.serial(mesh.size(), [&](std::size_t v) {
    if (mesh.counted(v) == 0) return;
    if (seen.of_stairs.empty())
      noise.vertices.push_back({static_cast<float>(seen.variance[v] / square),
                                static_cast<float>(seen.near_by[v] / square), static_cast<float>(seen.confidence[v])});
    else
      noise.vertices.push_back({static_cast<float>(seen.of_stairs[v] * seen.of_stairs[v] / square), 0, 0});
  });
  job.finish();
  return noise;
}

MeanNoise::MeanNoise(const GuidedWhole& whole, double average_edge_length)
    : testimony_(whole.testimony), has_grid_(whole.grid), average_edge_length_(average_edge_length) {
  testimony_.opposed /= average_edge_length * average_edge_length;
}

void MeanNoise::add(const std::vector<VertexNoise>& vertices) {
  const detail::NoiseByWhole whole(testimony_);
  for (const VertexNoise& v : vertices)
    squares_ += has_grid_ ? static_cast<double>(v.variance) : whole.variance(v.variance, v.near_by, v.confidence);
  vertices_ += vertices.size();
}

double MeanNoise::value() const {
  return vertices_ > 0 ? std::sqrt(squares_ / static_cast<double>(vertices_)) * average_edge_length_ : 0;
}

double correlated_noise(const MeshView& sample, const Progress& progress, int threads) {
  detail::Job job(progress, threads);
  const detail::MeshArrays mesh = read_told(sample, job);
  job.begin_stage(measuring, 1);
  const double noise = detail::correlated_noise_of(mesh, job);
  job.finish();
  return std::ldexp(noise, -mesh.exponent);
}

namespace {

std::vector<double> run_for_medians(const MeshView& view, const SmoothingParameters& parameters,
                                    std::vector<ValueCounts>* counts, const Progress& progress) {
  parameters.validate(Method::guided);
  detail::Job job(progress, parameters.threads);
  const detail::MeshArrays mesh = read_told(view, job);
  job.begin_stage(measuring, 1);
  detail::Array<std::uint8_t> movable(mesh.size());
  for (std::size_t v = 0; v < movable.size(); ++v)
    movable[v] = !detail::is_held(mesh, parameters, v) && !detail::is_isolated(mesh, v);
  const detail::Array<detail::Vec3> no_normals;
  std::vector<double> medians =
      detail::medians_of_guided_pass({mesh, mesh.position, no_normals, movable, job},
                                     detail::guided_settings(parameters, parameters.iterations), counts);
  job.finish();
  return medians;
}

}  // namespace

std::vector<double> guided_medians(const MeshView& view, const SmoothingParameters& parameters,
                                   const Progress& progress) {
  return run_for_medians(view, parameters, nullptr, progress);
}

void count_guided_values(const MeshView& piece, const SmoothingParameters& parameters, std::vector<ValueCounts>& counts,
                         const Progress& progress) {
  run_for_medians(piece, parameters, &counts, progress);
}

}  // namespace vcg_core
