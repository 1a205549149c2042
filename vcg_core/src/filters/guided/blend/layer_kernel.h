// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Included once by each of the files layer_kernel_*.cpp, after the Simd of their processor; like the paper filter's
// lane_kernel.h it calls nothing of the standard library.

#include "layer_kernels.h"

namespace vcg_core::detail {
namespace {

/// Outputs `first` and those after it, so many that their sums stay in registers: each input is loaded once for all.
template <unsigned Outputs>
void apply_to_outputs(const Layer& layer, std::size_t first, const BlockRow* in, BlockRow* out) {
  constexpr unsigned parts = block / Simd::lanes;
  Simd::Vector sum[Outputs][parts];
  for (unsigned o = 0; o < Outputs; ++o)
    for (unsigned part = 0; part < parts; ++part) sum[o][part] = Simd::set(layer.offset[first + o]);
  const float* weight = layer.matrix + first * layer.inputs;
  for (std::size_t i = 0; i < layer.inputs; ++i)
    for (unsigned part = 0; part < parts; ++part) {
      const Simd::Vector x = Simd::load(in[i].lane + part * Simd::lanes);
      for (unsigned o = 0; o < Outputs; ++o)
        sum[o][part] = Simd::add(sum[o][part], Simd::mul(Simd::set(weight[o * layer.inputs + i]), x));
    }
  for (unsigned o = 0; o < Outputs; ++o)
    for (unsigned part = 0; part < parts; ++part) {
      const Simd::Vector x = sum[o][part];
      Simd::store(out[first + o].lane + part * Simd::lanes,
                  layer.rectify ? Simd::max(x, Simd::mul(x, Simd::set(0.1F))) : x);
    }
}

template <unsigned Outputs>
void apply_layer(const Layer& layer, const BlockRow* in, BlockRow* out) {
  std::size_t first = 0;
  for (; first + Outputs <= layer.outputs; first += Outputs) apply_to_outputs<Outputs>(layer, first, in, out);
  for (; first < layer.outputs; ++first) apply_to_outputs<1>(layer, first, in, out);
}

}  // namespace
}  // namespace vcg_core::detail
