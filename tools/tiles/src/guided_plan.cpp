// SPDX-License-Identifier: GPL-3.0-or-later
#include "guided_plan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <vector>

#include <vcg_core/mesh/guided_measures.h>

#include "bucket_writer.h"
#include "median_sample.h"
#include "piece.h"
#include "voxel_grid.h"

namespace tiles {
namespace {

using vcg_core::GuidedWhole;
using vcg_core::VertexNoise;

/// Influence on the noise around a vertex decays as means over 36 rings do: at this distance, in |e|, to a millionth.
constexpr double noise_reach = 24;

/// The same of the values that the rounds' medians are over: what is farther away moves the medians by nothing that is
/// seen.
constexpr double median_reach = 16;

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

/// Some spots of the mesh with their surroundings.
Piece read_sample(const PieceReader& reader, const Plan& plan, std::size_t sample_vertices) {
  const double reach = median_reach * plan.average_edge_length;
  return reader.read(median_sample(plan, reach, sample_vertices), reach);
}

/// Looks for correlated noise on a sample of the mesh.
void measure_correlated_noise(const PieceReader& reader, Plan& plan, std::size_t sample_vertices, const Stage& stage) {
  Piece sample = read_sample(reader, plan, sample_vertices);
  if (sample.face.empty()) return;
  plan.guided->noise = vcg_core::correlated_noise(view_of(sample, plan), stage.part(0, 1), plan.job.parameters.threads);
  plan.guided->correlated = plan.guided->noise > 0;
}

/// The medians of the rounds: about, from a sample; then, unless that is all of the mesh, by the values of all pieces.
void measure_medians(const PieceReader& reader, Plan& plan, std::size_t sample_vertices, const Stage& stage) {
  const vcg_core::SmoothingParameters& parameters = plan.job.parameters;
  const Stage of_sample = stage.inner(0, 0.1), of_all = stage.inner(0.1, 1);
  {
    Piece sample = read_sample(reader, plan, sample_vertices);
    plan.guided->medians = vcg_core::guided_medians(view_of(sample, plan), parameters, of_sample.part(0, 1));
    if (sample.own_index.size() == plan.vertices) return;
  }
  std::vector<vcg_core::ValueCounts> counts;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    const double part = 1 / static_cast<double>(plan.tiles());
    Piece piece = reader.read(tile, median_reach * plan.average_edge_length);
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
  plan.guided->grid = find_voxel_grid(mesh, plan);
  const PieceReader reader(plan, mesh);
  measure_noise(reader, plan, stage.inner(0, 0.3));
  if (!(plan.guided->noise > 0)) measure_correlated_noise(reader, plan, sample_vertices, stage.inner(0.3, 0.4));
  if (plan.guided->noise > 0) measure_medians(reader, plan, sample_vertices, stage.inner(0.4, 1));
  return *plan.guided;
}

}  // namespace tiles
