// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include <Eigen/Core>

#include "samples.h"

namespace training {

/// A network in the making: vcg_core::detail::BlendNetwork with weights of single precision.
struct Network {
  Eigen::VectorXf mean, deviation;  ///< of the inputs
  std::vector<Eigen::MatrixXf> matrix;
  std::vector<Eigen::VectorXf> offset;
};

/// Minimises the mean over the samples of weight * sqrt(|n - truth|^2 + 0.003^2) + 0.01 (|sum| - 1)^2, where n is the
/// direction of the sum of candidates times outputs, by Adam (Kingma, Ba 2015) with a rate that falls as a cosine.
/// @param hidden  sizes of the hidden layers
Network train(const Samples& samples, const std::vector<int>& hidden, int epochs, std::uint64_t seed,
              std::ostream& log);

/// Blended normals of the samples, unit columns.
Eigen::MatrixXf blend(const Network& network, const Samples& samples);

}  // namespace training
