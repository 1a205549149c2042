// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>

#include "samples.h"

namespace training {

/// Mean angle in degrees between unit columns and the true normals, by the weights of the samples.
double mean_angle_to_truth(const Eigen::MatrixXf& normal, const Samples& samples);

/// The same samples as if the blend had no such candidate: neither to choose nor to see.
Samples without_candidate(Samples samples, std::size_t candidate);

/// The same samples without some of the scalars that a network sees, from `begin` to before `end`.
Samples without_scalars(Samples samples, std::size_t begin, std::size_t end);

/// Trains a stage with three seeds, then without each candidate and each group of scalars, and writes a table of what
/// that does to samples that were not learned from.
/// @param stage  1 or 2
void ablate(int stage, const Samples& learned, const Samples& kept_out, int epochs, std::uint64_t seed,
            std::ostream& out);

}  // namespace training
