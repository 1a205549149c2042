#include "noise_estimate.h"

#include <algorithm>
#include <cmath>

#include <vcg_core/detail/job.h>

namespace vcg_core::detail {

namespace {

constexpr std::size_t most_samples = std::size_t(1) << 17;

/// Median of the absolute value of a normal distribution of standard deviation 1.
constexpr double median_of_normal = 0.6745;

/// Standard deviation of v_i minus the mean of its six neighbours, all with independent noise of 1: sqrt(1 + 1/6).
constexpr double noise_of_height = 1.0801;

}  // namespace

double median(Array<double> value) {
  if (value.empty()) return 0;
  const std::size_t stride = (value.size() + most_samples - 1) / most_samples;
  std::size_t count = 0;
  for (std::size_t i = 0; i < value.size(); i += stride) value[count++] = value[i];
  value.resize(count);
  const auto middle = value.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(value.begin(), middle, value.end());
  return *middle;
}

double estimate_noise(const MeshArrays& mesh, const Array<Vec3>& position, const FaceGeometry& faces, Job& job) {
  constexpr double none = -1;
  const MeshTopology& topology = mesh.topology;
  Array<double> height(mesh.size(), none);
  job.parallel(mesh.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        if (topology.border[v] || topology.star_begin[v] == topology.star_begin[v + 1]) continue;
        Vec3 ring = Vec3::Zero();
        Vec3 normal = Vec3::Zero();
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
          const Index corner = topology.star[s];
          ring += position[vertex_of(mesh, next_in_face(corner))] + position[vertex_of(mesh, previous_in_face(corner))];
          normal += faces.normal[corner / 3];
        }
        const double length = normal.norm();
        if (!(length > 0)) continue;
        const double count = 2.0 * (topology.star_begin[v + 1] - topology.star_begin[v]);
        height[v] = std::abs((position[v] - ring / count).dot(normal) / length);
      }
  });
  height.erase(std::remove(height.begin(), height.end(), none), height.end());
  return median(std::move(height)) / (median_of_normal * noise_of_height);
}

double median_normal_difference(const Array<Vec3>& normal, const Array<Index>& across) {
  Array<double> difference;
  const std::size_t stride = std::max<std::size_t>(1, across.size() / (2 * most_samples));
  for (std::size_t corner = 0; corner < across.size(); corner += stride) {
    const Index g = across[corner];
    if (g != no_face && g > corner / 3) difference.push_back((normal[corner / 3] - normal[g]).norm());
  }
  return median(std::move(difference));
}

}  // namespace vcg_core::detail
