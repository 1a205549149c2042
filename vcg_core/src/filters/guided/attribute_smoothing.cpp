#include "attribute_smoothing.h"

#include <cmath>

#include <vcg_core/detail/job.h>

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

}  // namespace

void smooth_attributes(const MeshArrays& mesh, const Array<Vec3>& position, const Array<std::uint8_t>& movable,
                       const GuidedSettings& settings, VertexAttributes& attributes, Job& job) {
  const std::size_t channels = attributes.channels();
  if (channels == 0) return;
  const Array<Vec3> normal = vertex_normals(mesh, position, job);
  const RangeWeight similar(settings.fine_range);
  const MeshTopology& topology = mesh.topology;
  Array<double> smoothed = attributes.value;
  for (int ring = 0; ring < rings; ++ring) {
    job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
          for (std::size_t k = channels * v; k < channels * (v + 1); ++k) smoothed[k] = attributes.value[k];
          if (!movable[v]) continue;
          WeightedMean mean(channels);
          mean.add(&attributes.value[channels * v], 1);
          for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s)
            for (const Index corner : {next_in_face(topology.star[s]), previous_in_face(topology.star[s])}) {
              const Index w = vertex_of(mesh, corner);
              // Half: an inner edge is seen from both its faces.
              mean.add(&attributes.value[channels * w], 0.5 * similar((normal[w] - normal[v]).squaredNorm()));
            }
          mean.write(&smoothed[channels * v]);
        }
    });
    attributes.value.swap(smoothed);
  }
}

}  // namespace vcg_core::detail
