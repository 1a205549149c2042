// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "blend_network.h"

namespace vcg_core::detail {

/// The networks of both stages.
struct BlendWeights {
  NetworkTable first;
  NetworkTable second;
};

/// For noise that differs from vertex to vertex.
const BlendWeights& white_noise_weights();
/// For noise that is correlated over some edges.
const BlendWeights& correlated_noise_weights();

}  // namespace vcg_core::detail
