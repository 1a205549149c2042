// SPDX-License-Identifier: GPL-3.0-or-later
#include "network_trainer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

#include <mesh_tools/random.h>

namespace training {

namespace {

using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;

constexpr Index batch = 2048;
constexpr float softness = 0.003F;    ///< of the angle's absolute value at 0
constexpr float length_pull = 0.01F;  ///< towards sums of length 1
constexpr float leak = 0.1F;

/// Adam's memory of one array of weights.
struct Moments {
  explicit Moments(Index size) : first(Eigen::ArrayXf::Zero(size)), second(Eigen::ArrayXf::Zero(size)) {}

  void step(float* value, const float* gradient, float rate, int time) {
    const auto size = first.size();
    const Eigen::Map<const Eigen::ArrayXf> g(gradient, size);
    first += 0.1F * (g - first);
    second += 0.001F * (g.square() - second);
    const float first_scale = 1 / (1 - std::pow(0.9F, float(time)));
    const float second_scale = 1 / (1 - std::pow(0.999F, float(time)));
    Eigen::Map<Eigen::ArrayXf>(value, size) -= rate * first * first_scale / ((second * second_scale).sqrt() + 1e-8F);
  }

  Eigen::ArrayXf first, second;
};

/// The columns of the samples with these numbers.
struct Batch {
  MatrixXf input;
  std::vector<MatrixXf> candidate;
  MatrixXf truth;
  Eigen::RowVectorXf weight;
};

Batch gather(const Samples& samples, const Network& network, const std::vector<Index>& order, Index first,
             Index count) {
  Batch b;
  b.input.resize(samples.input.rows(), count);
  b.candidate.assign(samples.candidate.size(), MatrixXf(3, count));
  b.truth.resize(3, count);
  b.weight.resize(count);
  for (Index i = 0; i < count; ++i) {
    const Index s = order[static_cast<std::size_t>(first + i)];
    b.input.col(i) = (samples.input.col(s) - network.mean).cwiseQuotient(network.deviation);
    for (std::size_t c = 0; c < b.candidate.size(); ++c) b.candidate[c].col(i) = samples.candidate[c].col(s);
    b.truth.col(i) = samples.truth.col(s);
    b.weight[i] = samples.weight[s];
  }
  return b;
}

/// Values of all layers, the inputs first.
std::vector<MatrixXf> forward(const Network& network, const MatrixXf& input) {
  std::vector<MatrixXf> value{input};
  for (std::size_t k = 0; k < network.matrix.size(); ++k) {
    MatrixXf next = (network.matrix[k] * value.back()).colwise() + network.offset[k];
    if (k + 1 < network.matrix.size()) next = next.cwiseMax(leak * next);
    value.push_back(std::move(next));
  }
  return value;
}

MatrixXf sum_of(const std::vector<MatrixXf>& candidate, const MatrixXf& output) {
  MatrixXf sum = MatrixXf::Zero(3, output.cols());
  for (std::size_t c = 0; c < candidate.size(); ++c)
    sum += candidate[c] * output.row(static_cast<Index>(c)).asDiagonal();
  return sum;
}

Network fresh_network(const Samples& samples, const std::vector<int>& hidden, mesh_tools::Random& random) {
  Network network;
  network.mean = samples.input.rowwise().mean();
  network.deviation = ((samples.input.colwise() - network.mean).array().square().rowwise().mean().sqrt() + 1e-2F);
  std::vector<Index> sizes{samples.input.rows()};
  sizes.insert(sizes.end(), hidden.begin(), hidden.end());
  sizes.push_back(static_cast<Index>(samples.candidate.size()));
  for (std::size_t k = 0; k + 1 < sizes.size(); ++k) {
    MatrixXf matrix(sizes[k + 1], sizes[k]);
    const double scale = std::sqrt(2.0 / static_cast<double>(sizes[k])) * (k + 2 == sizes.size() ? 0.1 : 1);
    for (float& w : matrix.reshaped()) w = static_cast<float>(scale * random.normal());
    network.matrix.push_back(std::move(matrix));
    network.offset.emplace_back(VectorXf::Zero(sizes[k + 1]));
  }
  network.offset.back()[1] = network.offset.back()[2] = 0.5F;  // at first: the middle of two that are never far off
  return network;
}

}  // namespace

MatrixXf blend(const Network& network, const Samples& samples) {
  std::vector<Index> order(static_cast<std::size_t>(samples.input.cols()));
  std::iota(order.begin(), order.end(), Index(0));
  MatrixXf blended(3, samples.input.cols());
  for (Index first = 0; first < samples.input.cols(); first += batch) {
    const Index count = std::min(batch, samples.input.cols() - first);
    const Batch b = gather(samples, network, order, first, count);
    blended.middleCols(first, count) = sum_of(b.candidate, forward(network, b.input).back()).colwise().normalized();
  }
  return blended;
}

Network train(const Samples& samples, const std::vector<int>& hidden, int epochs, std::uint64_t seed,
              std::ostream& log) {
  mesh_tools::Random random(seed);
  Network network = fresh_network(samples, hidden, random);
  std::vector<Moments> matrix_moments, offset_moments;
  for (std::size_t k = 0; k < network.matrix.size(); ++k) {
    matrix_moments.emplace_back(network.matrix[k].size());
    offset_moments.emplace_back(network.offset[k].size());
  }
  std::vector<Index> order(static_cast<std::size_t>(samples.input.cols()));
  std::iota(order.begin(), order.end(), Index(0));
  const Index batches = samples.input.cols() / batch;
  const double steps = static_cast<double>(epochs) * static_cast<double>(batches);
  int time = 0;
  for (int epoch = 0; epoch < epochs; ++epoch) {
    for (std::size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
    double total = 0;
    for (Index number = 0; number < batches; ++number) {
      const Batch b = gather(samples, network, order, number * batch, batch);
      const std::vector<MatrixXf> value = forward(network, b.input);
      const MatrixXf sum = sum_of(b.candidate, value.back());
      const Eigen::RowVectorXf length = sum.colwise().norm().array() + 1e-9F;
      const MatrixXf unit = sum * length.cwiseInverse().asDiagonal();
      const MatrixXf difference = unit - b.truth;
      const Eigen::RowVectorXf error = (difference.colwise().squaredNorm().array() + softness * softness).sqrt();
      total += error.dot(b.weight) / batch;
      // Along the unit sphere, then through the length.
      const MatrixXf at_unit = difference * (b.weight.array() / error.array()).matrix().asDiagonal();
      const Eigen::RowVectorXf radial = unit.cwiseProduct(at_unit).colwise().sum();
      const MatrixXf at_sum = (at_unit - unit * radial.asDiagonal()) * length.cwiseInverse().asDiagonal() +
                              unit * (2 * length_pull * (length.array() - 1)).matrix().asDiagonal();
      MatrixXf slope(value.back().rows(), batch);
      for (std::size_t c = 0; c < b.candidate.size(); ++c)
        slope.row(static_cast<Index>(c)) = b.candidate[c].cwiseProduct(at_sum).colwise().sum() / float(batch);
      ++time;
      const double falling = 0.5 * (1 + std::cos(3.14159265 * time / steps));
      const auto rate = static_cast<float>((3e-3 * falling + 1e-5) * std::min(1.0, time / 200.0));
      for (std::size_t k = network.matrix.size(); k-- > 0;) {
        const MatrixXf of_matrix = slope * value[k].transpose();
        const VectorXf of_offset = slope.rowwise().sum();
        if (k > 0) {
          slope = network.matrix[k].transpose() * slope;
          slope = (value[k].array() > 0).select(slope, leak * slope);
        }
        matrix_moments[k].step(network.matrix[k].data(), of_matrix.data(), rate, time);
        offset_moments[k].step(network.offset[k].data(), of_offset.data(), rate, time);
      }
    }
    log << "epoch " << epoch + 1 << ": " << total / static_cast<double>(batches) << '\n' << std::flush;
  }
  return network;
}

}  // namespace training
