// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../unit_normals.h"
#include "candidates.h"
#include "layer_kernels.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Weights of a network as they stand in the source: integers, in multiples of 2^-12.
///
/// In this order: mean and standard deviation of each input; then for each layer its matrix, row by row, and its
/// offsets.
struct NetworkTable {
  static constexpr int layers = 3;
  std::size_t sizes[layers + 1];  ///< inputs, two hidden layers, outputs
  const std::int16_t* value;
  std::size_t count;
};

constexpr double table_unit = 1.0 / 4096;

constexpr std::size_t values_in(const std::size_t (&sizes)[NetworkTable::layers + 1]) {
  std::size_t count = 2 * sizes[0];
  for (int layer = 0; layer < NetworkTable::layers; ++layer) count += (sizes[layer] + 1) * sizes[layer + 1];
  return count;
}

/// A table whose numbers stand in an array.
template <std::size_t Count>
NetworkTable network_table(const std::size_t (&sizes)[NetworkTable::layers + 1], const std::int16_t (&value)[Count]) {
  return {{sizes[0], sizes[1], sizes[2], sizes[3]}, value, Count};
}

/// Fletcher's checksum of a table, for damage that a compiler can see.
constexpr std::uint32_t checksum(const std::int16_t* value, std::size_t count) {
  std::uint32_t low = 1, high = 0;
  for (std::size_t i = 0; i < count; ++i) {
    low = (low + static_cast<std::uint16_t>(value[i])) % 65521;
    high = (high + low) % 65521;
  }
  return high << 16 | low;
}

/// Finds the coefficients of the blend of candidates.
///
/// Inputs of a face are the distances between all pairs of its candidates and its scalars, so that the blend turns with
/// the mesh; two hidden layers with max(x, x / 10); as many outputs as candidates. The normal is the direction of the
/// sum of the candidates, each times its output; that of the safe candidate where the sum is short.
///
/// In the line of Wang, Liu, Tong: Mesh denoising via cascaded normal regression, 2016, which regresses normals from
/// filtered ones in a local frame; the coefficients from distances alone are this project's own.
class BlendNetwork {
 public:
  explicit BlendNetwork(const NetworkTable& table, const LayerKernel& kernel = *supported_layer_kernels().front());

  /// @param candidates  as many, with as many scalars, as the table is for
  Array<UnitNormal> blend(const Candidates& candidates, Job& job) const;

 private:
  struct Weights {
    std::vector<float> matrix;  ///< row by row
    std::vector<float> offset;
  };

  Layer layer(int k) const;

  std::vector<float> mean_;
  std::vector<float> inverse_deviation_;
  Weights weights_[NetworkTable::layers];
  std::size_t sizes_[NetworkTable::layers + 1];
  const LayerKernel& kernel_;
};

/// The inputs of a block of faces; its memory serves the next block too.
struct NetworkInputs {
  /// Those of faces first to first + count - 1, count <= block; the lanes beyond repeat the last one.
  void fill(const Candidates& candidates, std::size_t first, std::size_t count);

  /// A candidate of a face of the block.
  Vec3 normal(std::size_t candidate, std::size_t lane) const {
    const BlockRow* const of = coordinate_.data() + 3 * candidate;
    return {of[0].lane[lane], of[1].lane[lane], of[2].lane[lane]};
  }

  std::vector<BlockRow> row;  ///< one for each input

 private:
  std::vector<BlockRow> coordinate_;  ///< one for each coordinate of each candidate
};

/// Number of inputs for this many candidates and scalars.
constexpr std::size_t input_count(std::size_t candidates, std::size_t scalars) {
  return candidates * (candidates - 1) / 2 + scalars;
}

}  // namespace vcg_core::detail
