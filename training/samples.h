// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "filters/guided/blend/blend_network.h"
#include "training_mesh.h"

namespace training {

/// What a network learns from: one column for each face that was drawn.
struct Samples {
  Eigen::MatrixXf input;
  std::vector<Eigen::MatrixXf> candidate;  ///< 3 rows each
  Eigen::MatrixXf truth;                   ///< 3 rows
  Eigen::VectorXf weight;
  std::vector<const char*> family;
};

/// Angle in degrees between two unit vectors, as exact for small ones as for large ones.
double angle_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b);

/// What the noise of the meshes is like.
enum class NoiseKind {
  white,      ///< differs from vertex to vertex; meshes on which the filter sees no such noise are left out
  correlated  ///< may be correlated over some edges as well
};

/// Draws faces of the meshes of a seed and finds their candidates, for the first stage or the second.
/// @param first_stage  the network that the second stage builds on; null for the first stage
/// @param most         faces that are drawn of one mesh
Samples draw_samples(NoiseKind noise, std::uint64_t seed, std::size_t first_mesh, std::size_t end_mesh,
                     const vcg_core::detail::BlendNetwork* first_stage, std::size_t most);

}  // namespace training
