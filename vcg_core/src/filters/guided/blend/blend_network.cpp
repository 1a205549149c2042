// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend_network.h"

#include <algorithm>
#include <cmath>

#include "../four_normals.h"
#include "job.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 64 * block;

/// A sum of candidates that is shorter has no direction to rely on.
constexpr double no_direction = 0.05;

}  // namespace

BlendNetwork::BlendNetwork(const NetworkTable& table, const LayerKernel& kernel) : kernel_(kernel) {
  const std::int16_t* next = table.value;
  const auto take = [&](std::vector<float>& values, std::size_t count) {
    values.resize(count);
    for (float& value : values) value = static_cast<float>(*next++ * table_unit);
  };
  std::copy(std::begin(table.sizes), std::end(table.sizes), std::begin(sizes_));
  take(mean_, sizes_[0]);
  take(inverse_deviation_, sizes_[0]);
  for (float& deviation : inverse_deviation_) deviation = 1 / deviation;
  for (int k = 0; k < NetworkTable::layers; ++k) {
    take(weights_[k].matrix, sizes_[k] * sizes_[k + 1]);
    take(weights_[k].offset, sizes_[k + 1]);
  }
}

Layer BlendNetwork::layer(int k) const {
  return {sizes_[k], sizes_[k + 1], weights_[k].matrix.data(), weights_[k].offset.data(), k + 1 < NetworkTable::layers};
}

void NetworkInputs::fill(const Candidates& candidates, std::size_t first, std::size_t count) {
  const std::size_t size = candidates.size();
  row.resize(input_count(size, candidates.scalar.size()));
  coordinate_.resize(3 * size);
  for (std::size_t c = 0; c < size; ++c) {
    PackedNormal normal[block];
    for (std::size_t lane = 0; lane < block; ++lane)
      normal[lane] = candidates.normal[c][first + std::min(lane, count - 1)];
    for (std::size_t lane = 0; lane < block; lane += 4) {
      const FourNormals four = unpacked(normal + lane);
      four.x.store(coordinate_[3 * c].lane + lane);
      four.y.store(coordinate_[3 * c + 1].lane + lane);
      four.z.store(coordinate_[3 * c + 2].lane + lane);
    }
  }
  BlockRow* next = row.data();
  for (std::size_t a = 0; a < size; ++a)
    for (std::size_t b = a + 1; b < size; ++b, ++next) {
      const BlockRow* p = coordinate_.data() + 3 * a;
      const BlockRow* q = coordinate_.data() + 3 * b;
      for (std::size_t lane = 0; lane < block; ++lane) {
        const float x = p[0].lane[lane] - q[0].lane[lane];
        const float y = p[1].lane[lane] - q[1].lane[lane];
        const float z = p[2].lane[lane] - q[2].lane[lane];
        next->lane[lane] = std::sqrt(x * x + y * y + z * z);
      }
    }
  for (const Array<PackedNumber>& scalar : candidates.scalar) {
    for (std::size_t lane = 0; lane < block; ++lane)
      next->lane[lane] = scalar[first + std::min(lane, count - 1)].value();
    ++next;
  }
}

Array<UnitNormal> BlendNetwork::blend(const Candidates& candidates, Job& job) const {
  Array<UnitNormal> blended(candidates.normal.front().size());
  job.parallel(blended.size(), grain, Loop::minor, [&](Chunks& chunks) {
    NetworkInputs inputs;
    std::vector<BlockRow> outputs;
    std::vector<BlockRow>& values = inputs.row;  // of the layers in turn
    while (chunks.next())
      for (std::size_t first = chunks.begin(); first < chunks.end(); first += block) {
        const std::size_t count = std::min(block, chunks.end() - first);
        inputs.fill(candidates, first, count);
        for (std::size_t i = 0; i < sizes_[0]; ++i)
          for (float& value : values[i].lane) value = (value - mean_[i]) * inverse_deviation_[i];
        for (int k = 0; k < NetworkTable::layers; ++k) {
          outputs.resize(sizes_[k + 1]);
          kernel_.apply(layer(k), values.data(), outputs.data());
          values.swap(outputs);
        }
        for (std::size_t lane = 0; lane < count; ++lane) {
          const std::size_t f = first + lane;
          Vec3 sum = Vec3::Zero();
          for (std::size_t c = 0; c < candidates.size(); ++c)
            sum += static_cast<double>(values[c].lane[lane]) * inputs.normal(c, lane);
          const double length = sum.norm();
          blended[f] = in_single(length > no_direction ? Vec3(sum / length) : inputs.normal(safe_candidate, lane));
        }
      }
  });
  return blended;
}

}  // namespace vcg_core::detail
