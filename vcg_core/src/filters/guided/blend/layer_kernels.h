// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace vcg_core::detail {

/// Faces that are worked on at once, side by side.
constexpr std::size_t block = 16;

/// One value of each face of a block.
struct alignas(64) BlockRow {
  float lane[block];
};

/// A layer of a network.
struct Layer {
  std::size_t inputs;
  std::size_t outputs;
  const float* matrix;  ///< outputs times inputs, row by row
  const float* offset;  ///< by output
  bool rectify;         ///< whether an output x becomes max(x, x / 10)
};

/// Applies layers by vectors of one width. Products and sums are rounded one by one, in the order of the inputs, so
/// that all give the same bits.
struct LayerKernel {
  const char* name;
  bool (*supported)();
  /// @param in   layer.inputs rows
  /// @param out  layer.outputs rows
  void (*apply)(const Layer& layer, const BlockRow* in, BlockRow* out);
};

/// The kernels that this processor can run, the fastest first; the last one runs on all.
std::vector<const LayerKernel*> supported_layer_kernels();

}  // namespace vcg_core::detail
