// SPDX-License-Identifier: GPL-3.0-or-later
#include "attribute_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "job.h"
#include "range_weight.h"
#include "vertex_normals.h"

namespace vcg_core::detail {

namespace {

constexpr int rings = 10;
constexpr std::size_t most_channels = 5;

/// Adds weighted values up, each channel by itself: one of them may be undefined at a vertex.
class WeightedMean {
 public:
  explicit WeightedMean(std::size_t channels) : channels_(channels) {}

  void add(const double* value, double weight) {
    for (std::size_t k = 0; k < channels_; ++k) {
      if (!std::isfinite(value[k])) continue;
      sum_[k] += weight * value[k];
      weight_[k] += weight;
    }
  }

  void write(double* value) const {
    for (std::size_t k = 0; k < channels_; ++k)
      if (std::isfinite(value[k]) && weight_[k] > 0) value[k] = sum_[k] / weight_[k];
  }

 private:
  std::size_t channels_;
  double sum_[most_channels] = {};
  double weight_[most_channels] = {};
};

/// The order of copies by their numbers, those that are undefined last.
class ByNumbers {
 public:
  explicit ByNumbers(const VertexAttributes& attributes)
      : value_(attributes.value.data()), channels_(attributes.channels()) {}

  bool operator()(Index a, Index b) const {
    for (std::size_t k = 0; k < channels_; ++k) {
      const double x = value_[channels_ * a + k], y = value_[channels_ * b + k];
      if (std::isnan(x) != std::isnan(y)) return std::isnan(y);
      if (x < y || x > y) return x < y;
    }
    return false;
  }

 private:
  const double* value_;
  std::size_t channels_;
};

/// For each copy the first one of its vertex that has the same numbers.
Array<Index> find_leaders(const MeshArrays& mesh, const VertexAttributes& attributes, Job& job) {
  const ByNumbers less(attributes);
  Array<Index> leader(mesh.host_vertex.size());
  job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    std::vector<Index> copies;
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        copies.resize(mesh.copies(v));
        std::iota(copies.begin(), copies.end(), static_cast<Index>(mesh.first_copy(v)));
        std::stable_sort(copies.begin(), copies.end(), less);
        for (std::size_t i = 0; i < copies.size(); ++i)
          leader[copies[i]] = i > 0 && !less(copies[i - 1], copies[i]) ? leader[copies[i - 1]] : copies[i];
      }
  });
  return leader;
}

/// One round: the weighted means over the one ring, for all copies of one vertex after the other.
class AttributeRound {
 public:
  AttributeRound(const MeshArrays& mesh, const Array<Vec3>& normal, const Array<Index>& leader, std::size_t channels,
                 const RangeWeight<double>& similar)
      : mesh_(mesh), normal_(normal), leader_(leader), channels_(channels), similar_(similar) {}

  void visit(Index v, const Array<double>& value, Array<double>& smoothed) {
    const std::size_t first = mesh_.first_copy(v), last = mesh_.first_copy(v + 1);
    means_.assign(last - first, WeightedMean(channels_));
    for (std::size_t copy = first; copy < last; ++copy) means_[copy - first].add(&value[channels_ * copy], 1);
    for (Index s = mesh_.topology.star_begin[v]; s < mesh_.topology.star_begin[v + 1]; ++s) {
      const Index here = mesh_.topology.star[s];
      WeightedMean& mean = means_[leader_[copy_of(mesh_, here)] - first];
      for (const Index corner : {next_in_face(here), previous_in_face(here)}) {
        const Vec3& n = normal_[vertex_of(mesh_, corner)];
        // Half: an inner edge is seen from both its faces.
        mean.add(&value[channels_ * copy_of(mesh_, corner)], 0.5 * similar_((n - normal_[v]).squaredNorm()));
      }
    }
    for (std::size_t copy = first; copy < last; ++copy)
      means_[leader_[copy] - first].write(&smoothed[channels_ * copy]);
  }

 private:
  const MeshArrays& mesh_;
  const Array<Vec3>& normal_;
  const Array<Index>& leader_;
  std::size_t channels_;
  const RangeWeight<double>& similar_;
  std::vector<WeightedMean> means_;  ///< of the copies of one vertex
};

}  // namespace

void smooth_attributes(const MeshArrays& mesh, const Array<Vec3>& position, const Array<std::uint8_t>& movable,
                       const GuidedSettings& settings, VertexAttributes& attributes, Job& job) {
  const std::size_t channels = attributes.channels();
  if (channels == 0) return;
  const Array<Vec3> normal = vertex_normals(mesh, position, job);
  const RangeWeight<double> similar(settings.fine_range);
  const Array<Index> leader = find_leaders(mesh, attributes, job);
  Array<double> smoothed = attributes.value;
  for (int ring = 0; ring < rings; ++ring) {
    job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
      AttributeRound round(mesh, normal, leader, channels, similar);
      while (chunks.next()) {
        const auto first = static_cast<std::ptrdiff_t>(channels * mesh.first_copy(chunks.begin()));
        const auto last = static_cast<std::ptrdiff_t>(channels * mesh.first_copy(chunks.end()));
        std::copy(attributes.value.begin() + first, attributes.value.begin() + last, smoothed.begin() + first);
        for (auto v = static_cast<Index>(chunks.begin()); v < chunks.end(); ++v)
          if (movable[v]) round.visit(v, attributes.value, smoothed);
      }
    });
    attributes.value.swap(smoothed);
  }
}

}  // namespace vcg_core::detail
