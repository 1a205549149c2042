// SPDX-License-Identifier: GPL-3.0-or-later
#include "bmd_filter.h"

#include "filters/weights.h"
#include "job.h"
#include "point_grid.h"
#include "polled_copy.h"

namespace vcg_core::detail {

namespace {

Array<Index> vertices_with_faces(const MeshArrays& mesh, Job& job) {
  Array<Index> vertices;
  vertices.reserve(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) {
    if (mesh.topology.star_begin[v] != mesh.topology.star_begin[v + 1]) vertices.push_back(static_cast<Index>(v));
  });
  return vertices;
}

/// There is no normal weight: the difference of normals is given as 0.
constexpr double any_sigma_n = 1;

/// Section 3's d_i, in |e|. `unit` is |e|.
double bmd_offset(const Vec3& v_i, const Vec3& n_i, PointGrid::Search& ball, const GaussianWeights& weights,
                  double unit) {
  double sum = 0;
  double sum_of_weights = 0;
  ball.for_each_near(v_i, [&](Index, const Vec3& v_j) {
    const Vec3 from_j = (v_i - v_j) / unit;
    const double height = n_i.dot(from_j);
    const double w = weights.product(from_j.squaredNorm(), height, 0);
    sum += w * height;
    sum_of_weights += w;
  });
  return sum / sum_of_weights;  // v_i itself has weight 1
}

PassOutput bmd_pass(const PassInput& in, const BilateralParameters& p) {
  const double unit = in.mesh.topology.average_edge_length;
  const GaussianWeights weights(p.sigma_c, p.sigma_s, any_sigma_n, p.gaussian);
  const PointGrid grid(in.position, vertices_with_faces(in.mesh, in.job), p.rho * p.sigma_c * unit, &in.job);
  in.job.report(0.0);
  PassOutput out{polled_copy(in.position, in.job)};
  in.job.parallel(in.mesh.size(), 256, [&](Chunks& chunks) {
    PointGrid::Search ball(grid);
    while (chunks.next())
      for (std::size_t i = chunks.begin(); i < chunks.end(); ++i) {
        if (!in.movable[i] || in.normal[i].isZero(0)) continue;
        chunks.poll();
        out.position[i] -= in.normal[i] * (bmd_offset(in.position[i], in.normal[i], ball, weights, unit) * unit);
      }
  });
  return out;
}

}  // namespace

Filter bmd_filter() {
  const BilateralRows<SmoothingParameters> bilateral;
  const CommonRows<SmoothingParameters> common;
  return {{Method::bmd,
           "bmd",
           "Bilateral mesh denoising",
           {bilateral.sigma_c, bilateral.sigma_s, common.iterations, common.boundary, common.selected, bilateral.rho,
            bilateral.gaussian}},
          "use the guided filter; a smaller sigma_s moves less",
          true,
          [](const SmoothingParameters& all) { return bind_pass<BilateralParameters>(bmd_pass, all); }};
}

}  // namespace vcg_core::detail
