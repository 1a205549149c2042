// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper_filter.h"

#include <memory>

#include "filters/weights.h"
#include "geodesic_march.h"
#include "job.h"
#include "lanes/lane_filter.h"
#include "triangle_frames.h"

namespace vcg_core::detail {

namespace {

/// Gain, in |e|, that opens a settled vertex again.
constexpr double reopen_gain = 1e-9;

/// Section 6's d_i, in |e|, over the vertices that the march from v_i reached. `unit` is |e|.
double paper_offset(Index i, const GeodesicMarch<double>& march, const Array<Vec3>& position, const Array<Vec3>& normal,
                    double cutoff, const GaussianWeights& weights, double unit) {
  double sum = 0;
  double sum_of_weights = 0;
  for (const Index j : march.reached()) {
    if (!(march.distance(j) < cutoff) || normal[j].isZero(0)) continue;
    const Vec3 from_j = (position[i] - position[j]) / unit;
    const double height = normal[j].dot(from_j);
    const double w = weights.product(from_j.squaredNorm(), height, 1 - normal[i].dot(normal[j]));
    sum += w * height;
    sum_of_weights += w;
  }
  // v_i itself has weight 1, but for a cut-off so small that it is 0.
  return sum_of_weights > 0 ? sum / sum_of_weights : 0;
}

}  // namespace

Array<Vec3> paper_pass(const MeshArrays& mesh, const Array<Vec3>& position, const Array<Vec3>& normal,
                       const Array<std::uint8_t>& movable, const PaperParameters& parameters, Job& job) {
  const double unit = mesh.topology.average_edge_length;
  const double cutoff = parameters.rho * parameters.sigma_c;
  const GaussianWeights weights(parameters.sigma_c, parameters.sigma_s, parameters.sigma_n, parameters.gaussian);
  const Array<TriangleFrame<double>> frames = triangle_frames(mesh, position, unit, job);
  Array<Vec3> moved = position;
  job.parallel(mesh.size(), 64, [&](Chunks& chunks) {
    GeodesicMarch<double> march(mesh, frames, reopen_gain);
    while (chunks.next())
      for (std::size_t i = chunks.begin(); i < chunks.end(); ++i) {
        if (!movable[i] || normal[i].isZero(0)) continue;
        const auto source = static_cast<Index>(i);
        march.run(source, cutoff + march_margin, [&](std::size_t) { chunks.poll(); });
        const double offset = paper_offset(source, march, position, normal, cutoff, weights, unit);
        moved[i] -= normal[i] * (offset * unit);
      }
  });
  return moved;
}

namespace {

FilterPass make_paper_pass(const SmoothingParameters& all) {
  const PaperParameters& parameters = all;
  if (parameters.arithmetic == Arithmetic::reference)
    return [parameters](const PassInput& in) {
      return PassOutput{paper_pass(in.mesh, in.position, in.normal, in.movable, parameters, in.job)};
    };
  const auto lanes = std::make_shared<LanePass>(parameters);  // shared, as a FilterPass can be copied
  return [lanes](const PassInput& in) { return lanes->run(in); };
}

}  // namespace

Filter paper_filter() {
  return {{Method::paper, "paper", "Anisotropic feature-preserving smoothing", paper_parameters<SmoothingParameters>()},
          "this filter moves convex shapes outwards, the more the coarser they are: use the guided filter; a smaller"
          " sigma_s moves less",
          true,
          make_paper_pass};
}

}  // namespace vcg_core::detail
