// SPDX-License-Identifier: GPL-3.0-or-later
#include "guided_plan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <vcg_core/mesh/guided_measures.h>

#include "bucket_file.h"
#include "bucket_writer.h"
#include "median_sample.h"
#include "piece.h"

namespace tiles {
namespace {

using vcg_core::GuidedWhole;
using vcg_core::VertexNoise;

/// Influence on the noise around a vertex decays as means over 36 rings do: at this distance, in |e|, to a millionth.
constexpr double noise_reach = 24;

/// That on what the medians of the coarse rounds are over.
constexpr double median_reach = 16;

/// @param size  bytes of a number
Point point_at(const char* raw, std::size_t size) {
  Point p{};
  for (std::size_t k = 0; k < 3; ++k) {
    float narrow = 0;
    std::memcpy(size == sizeof narrow ? static_cast<void*>(&narrow) : &p[k], raw + k * size, size);
    if (size == sizeof narrow) p[k] = narrow;
  }
  return p;
}

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Zero without area.
Point normal_of(const Point& a, const Point& b, const Point& c) {
  const Point p = difference(b, a), q = difference(c, a);
  Point n = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

/// The vertices of some cells, and the normals of the faces that lie in one of them with all three corners.
class GridSampler {
 public:
  explicit GridSampler(std::size_t real_size) : real_size_(real_size) {}

  void add(const BucketPart& cell) {
    std::vector<Point> place;
    for (std::size_t i = 0; i < cell.vertex.size(); ++i)
      place.push_back(point_at(cell.position.data() + i * 3 * real_size_, real_size_));
    sample.vertices.insert(sample.vertices.end(), place.begin(), place.end());
    for (const BucketFace& face : cell.face) {
      Point corner[3];
      bool is_whole = true;
      for (std::size_t k = 0; k < 3 && is_whole; ++k) {
        const auto found = std::find(cell.vertex.begin(), cell.vertex.end(), face.vertex[k]);
        is_whole = found != cell.vertex.end();
        if (is_whole) corner[k] = place[static_cast<std::size_t>(found - cell.vertex.begin())];
      }
      if (is_whole) sample.normals.push_back(normal_of(corner[0], corner[1], corner[2]));
    }
  }

  vcg_core::VoxelGridSample sample;

 private:
  std::size_t real_size_;
};

void thin_out(std::vector<Point>& points, std::size_t wanted) {
  const std::size_t stride = std::max<std::size_t>(1, points.size() / wanted);
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) points[count++] = points[i];
  points.resize(count);
}

/// From cells that are spread evenly over the tiles.
vcg_core::VoxelGridSample sample_cells(const Plan& plan) {
  constexpr std::size_t wanted_vertices = 4096, wanted_normals = 65536;
  std::size_t cells = 0;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile)
    cells += BucketFile(plan.bucket_path(tile), plan.real_size).cells();
  const double in_cell = static_cast<double>(plan.faces) / static_cast<double>(std::max<std::size_t>(1, cells));
  const auto stride = static_cast<std::size_t>(
      std::max(1.0, static_cast<double>(cells) * std::max(1.0, in_cell) / static_cast<double>(wanted_normals)));
  GridSampler sampler(plan.real_size);
  std::size_t at = 0;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    const BucketFile bucket(plan.bucket_path(tile), plan.real_size);
    for (std::size_t i = 0; i < bucket.cells(); ++i, ++at) {
      if (at % stride != 0) continue;
      BucketPart part;
      bucket.read(i, i + 1, part);
      sampler.add(part);
    }
  }
  thin_out(sampler.sample.vertices, wanted_vertices);
  return std::move(sampler.sample);
}

std::optional<vcg_core::VoxelGrid> find_grid(const LargeMesh& mesh, const Plan& plan) {
  return vcg_core::find_voxel_grid(sample_cells(plan), plan.average_edge_length, [&](const vcg_core::VoxelGrid& grid) {
    vcg_core::VoxelLevelCounts counts{};
    std::vector<Point> position(1 << 14);
    VertexStream stream(mesh);
    while (const std::size_t count = stream.read(position))
      for (std::size_t i = 0; i < count; ++i) ++counts[vcg_core::voxel_levels(position[i], grid)];
    return counts;
  });
}

/// What the vertices tell of the noise, on the disk until all have been heard.
class NoiseFile {
 public:
  explicit NoiseFile(const Plan& plan) : path_(plan.folder / "noise") {}
  ~NoiseFile() {
    std::error_code error;
    std::filesystem::remove(path_, error);
  }
  NoiseFile(const NoiseFile&) = delete;
  NoiseFile& operator=(const NoiseFile&) = delete;

  void add(const std::vector<VertexNoise>& vertices) const {
    append_to_file(path_, vertices.data(), vertices.size() * sizeof(VertexNoise));
  }

  double mean(const GuidedWhole& whole, double average_edge_length) const {
    vcg_core::MeanNoise mean(whole, average_edge_length);
    const InputFile file(path_);
    std::vector<VertexNoise> part;
    for (std::uint64_t at = 0; at < file.size(); at += part.size() * sizeof(VertexNoise)) {
      part.resize(std::min<std::size_t>(1 << 16, (file.size() - at) / sizeof(VertexNoise)));
      file.read(at, part.data(), part.size() * sizeof(VertexNoise));
      mean.add(part);
    }
    return mean.value();
  }

 private:
  std::filesystem::path path_;
};

/// Of vertices that no face touches.
vcg_core::NoiseOfPiece no_noise(const Piece& piece) { return {{}, std::vector<VertexNoise>(piece.own_index.size())}; }

void measure_noise(const PieceReader& reader, Plan& plan, const Stage& stage) {
  const NoiseFile file(plan);
  GuidedWhole::Testimony& all = plan.guided->testimony;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    const double part = 1 / static_cast<double>(plan.tiles());
    Piece piece = reader.read(tile, noise_reach * plan.average_edge_length);
    const vcg_core::NoiseOfPiece noise =
        piece.face.empty() ? no_noise(piece)
                           : vcg_core::noise_of_piece(
                                 view_of(piece, plan),
                                 stage.part(part * static_cast<double>(tile), part * static_cast<double>(tile + 1)),
                                 plan.job.parameters.threads);
    all.opposed += noise.testimony.opposed;
    all.expected += noise.testimony.expected;
    all.trusted += noise.testimony.trusted;
    all.asked += noise.testimony.asked;
    file.add(noise.vertices);
  }
  plan.guided->noise = file.mean(*plan.guided, plan.average_edge_length);
}

/// The medians of the rounds: about, from a sample; then, unless that is all of the mesh, by the values of all pieces.
void measure_medians(const PieceReader& reader, Plan& plan, std::size_t sample_vertices, const Stage& stage) {
  const double reach = median_reach * plan.average_edge_length;
  const vcg_core::SmoothingParameters& parameters = plan.job.parameters;
  const Stage of_sample = stage.inner(0, 0.1), of_all = stage.inner(0.1, 1);
  {
    Piece sample = reader.read(median_sample(plan, reach, sample_vertices), reach);
    plan.guided->medians = vcg_core::guided_medians(view_of(sample, plan), parameters, of_sample.part(0, 1));
    if (sample.own_index.size() == plan.vertices) return;
  }
  std::vector<vcg_core::ValueCounts> counts;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    const double part = 1 / static_cast<double>(plan.tiles());
    Piece piece = reader.read(tile, reach);
    if (piece.face.empty()) continue;
    vcg_core::count_guided_values(view_of(piece, plan), parameters, counts,
                                  of_all.part(part * static_cast<double>(tile), part * static_cast<double>(tile + 1)));
  }
  for (std::size_t i = 0; i < plan.guided->medians.size(); ++i) plan.guided->medians[i] = counts[i].median();
}

}  // namespace

double guided_reach(const vcg_core::SmoothingParameters& parameters) {
  constexpr double reach = 40;  // of the blend's low-passes of 35 edges
  constexpr double without_blend = 24;
  constexpr double most_rounds = 12;  // unless the parameter asks for more
  const double of_rounds = parameters.blend == vcg_core::Blend::on ? reach : without_blend;
  return of_rounds * std::sqrt(std::max(1.0, parameters.iterations / most_rounds));
}

GuidedWhole measure_guided(const LargeMesh& mesh, const Plan& of_cut, std::size_t sample_vertices, const Stage& stage) {
  Plan plan = of_cut;
  plan.guided.emplace();
  plan.guided->grid = find_grid(mesh, plan);
  const PieceReader reader(plan, mesh);
  measure_noise(reader, plan, stage.inner(0, 0.3));
  if (plan.guided->noise > 0) measure_medians(reader, plan, sample_vertices, stage.inner(0.3, 1));
  return *plan.guided;
}

}  // namespace tiles
