// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <thread>

#include <job.h>
#include <mesh/read_mesh.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vcg_core/method.h>

#include "filters/guided/coarse_rounds.h"
#include "filters/guided/correlated_noise.h"

namespace training {

namespace {

using namespace vcg_core::detail;

/// Mean angle in degrees between columns.
double mean_angle(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b) {
  double sum = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i) sum += angle_between(a.col(i), b.col(i));
  return a.cols() > 0 ? sum / static_cast<double>(a.cols()) : 0;
}

/// The true normals in the core's order of faces, which it finds by their vertices.
std::vector<vcg::Point3d> truth_by_core_face(const MeshArrays& mesh, const TrainingMesh& example) {
  std::map<std::array<std::size_t, 3>, std::size_t> number;
  const auto key = [](std::array<std::size_t, 3> v) {
    std::sort(v.begin(), v.end());
    return v;
  };
  for (std::size_t f = 0; f < example.noisy.face.size(); ++f) {
    const auto& face = example.noisy.face[f];
    number[key({vcg::tri::Index(example.noisy, face.cV(0)), vcg::tri::Index(example.noisy, face.cV(1)),
                vcg::tri::Index(example.noisy, face.cV(2))})] = f;
  }
  std::vector<vcg::Point3d> truth;
  for (const auto& v : mesh.face) {
    const auto place =
        number.find(key({mesh.host_vertex[mesh.first_copy(v[0])], mesh.host_vertex[mesh.first_copy(v[1])],
                         mesh.host_vertex[mesh.first_copy(v[2])]}));
    truth.push_back(place == number.end() ? vcg::Point3d(0, 0, 0) : example.normal[place->second]);
  }
  return truth;
}

std::optional<Samples> samples_of(NoiseKind noise, std::uint64_t seed, std::size_t number,
                                  const BlendNetwork* first_stage, std::size_t most) {
  TrainingMesh example = make_training_mesh(seed, number);
  const vcg_core::Progress silent;
  Job job(silent, 1);
  job.begin_stage("", 1);
  const MeshArrays mesh = read_mesh(vcg_core::view_of(example.noisy), job);
  Array<std::uint8_t> movable(mesh.size());
  for (std::size_t v = 0; v < mesh.size(); ++v)
    movable[v] = mesh.topology.star_begin[v] < mesh.topology.star_begin[v + 1];
  const Array<Vec3> no_normals;
  const GuidedSettings settings = guided_settings({}, 0);
  const PassInput input{mesh, mesh.position, no_normals, movable, job};
  std::optional<CoarseRounds> coarse(std::in_place, input, settings);
  if (!(coarse->noise() > 0) && noise == NoiseKind::correlated)
    coarse.emplace(input, settings, find_correlated_noise(input));
  if (!(coarse->noise() > 0)) return std::nullopt;
  coarse->run();
  CoarseResult result = coarse->take_result();
  Candidates candidates = first_candidates(result, job);
  if (first_stage != nullptr) candidates = second_candidates(result, first_stage->blend(candidates, job), job);

  const std::vector<vcg::Point3d> truth = truth_by_core_face(mesh, example);
  std::vector<std::size_t> drawn;
  mesh_tools::Random random(seed + number);
  for (std::size_t f = 0; f < mesh.face.size(); ++f)
    if (truth[f].SquaredNorm() > 0 && random.uniform() * static_cast<double>(mesh.face.size()) < double(most))
      drawn.push_back(f);
  if (drawn.empty()) return std::nullopt;

  const auto count = static_cast<Eigen::Index>(drawn.size());
  const auto inputs = static_cast<Eigen::Index>(input_count(candidates.size(), candidates.scalar.size()));
  Samples samples;
  samples.input.resize(inputs, count);
  samples.candidate.assign(candidates.size(), Eigen::MatrixXf(3, count));
  samples.truth.resize(3, count);
  samples.family.assign(drawn.size(), example.family);
  double mean_area = 0;
  FaceGeometry noisy;
  noisy.measure(mesh, mesh.position, job);
  for (const double area : noisy.area) mean_area += area / static_cast<double>(mesh.face.size());
  samples.weight.resize(count);
  NetworkInputs face_inputs;
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t f = drawn[static_cast<std::size_t>(i)];
    face_inputs.fill(candidates, f, 1);
    for (Eigen::Index k = 0; k < inputs; ++k)
      samples.input(k, i) = face_inputs.row[static_cast<std::size_t>(k)].lane[0];
    for (std::size_t c = 0; c < candidates.size(); ++c)
      samples.candidate[c].col(i) = face_inputs.normal(c, 0).cast<float>();
    for (int axis = 0; axis < 3; ++axis) samples.truth(axis, i) = static_cast<float>(truth[f][axis]);
    // Between a mean over faces and one over areas, so that slivers count for less.
    samples.weight[i] = static_cast<float>(std::min(1.0, 0.3 + 0.7 * noisy.area[f] / mean_area));
  }
  // Each mesh counts for how far it is above what can be reached on it.
  double best = 180;
  for (const auto& candidate : samples.candidate) best = std::min(best, mean_angle(candidate, samples.truth));
  samples.weight *= static_cast<float>(3 / (0.45 + best));
  return samples;
}

}  // namespace

double angle_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return 2 * std::asin(std::min(1.0, 0.5 * static_cast<double>((a - b).norm()))) * 57.29578;
}

Samples draw_samples(NoiseKind noise, std::uint64_t seed, std::size_t first_mesh, std::size_t end_mesh,
                     const BlendNetwork* first_stage, std::size_t most) {
  std::vector<std::optional<Samples>> part(end_mesh - first_mesh);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < part.size(); i = next++)
      part[i] = samples_of(noise, seed, first_mesh + i, first_stage, most);
  };
  std::thread other(work);
  work();
  other.join();
  Eigen::Index total = 0;
  Samples all;
  for (const auto& one : part)
    if (one) {
      total += one->input.cols();
      if (all.candidate.empty()) {
        all.candidate.resize(one->candidate.size());
        all.input.resize(one->input.rows(), 0);
      }
    }
  all.input.resize(all.input.rows(), total);
  for (auto& candidate : all.candidate) candidate.resize(3, total);
  all.truth.resize(3, total);
  all.weight.resize(total);
  Eigen::Index at = 0;
  for (auto& one : part) {
    if (!one) continue;
    const Eigen::Index count = one->input.cols();
    all.input.middleCols(at, count) = one->input;
    for (std::size_t c = 0; c < all.candidate.size(); ++c) all.candidate[c].middleCols(at, count) = one->candidate[c];
    all.truth.middleCols(at, count) = one->truth;
    all.weight.segment(at, count) = one->weight;
    all.family.insert(all.family.end(), one->family.begin(), one->family.end());
    at += count;
    one.reset();
  }
  return all;
}

}  // namespace training
