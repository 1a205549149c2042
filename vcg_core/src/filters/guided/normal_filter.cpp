// SPDX-License-Identifier: GPL-3.0-or-later
#include "normal_filter.h"

#include <vcg_core/detail/job.h>

#include "range_weight.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 1024;

/// Below this length a weighted sum of normals has no direction: they cancel each other, or all weights vanish.
constexpr double no_direction = 1e-12;

}  // namespace

Array<double> closeness_weights(const FaceLists& within, const FaceGeometry& faces, const Array<double>& spacing,
                                double closeness, Job& job) {
  Array<double> weight(within.face.size());
  job.parallel(spacing.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const RangeWeight close(closeness * spacing[f]);
        const double unit = 1 / (spacing[f] * spacing[f]);  // areas as multiples of it neither over- nor underflow
        for (std::size_t k = within.begin[f]; k < within.begin[f + 1]; ++k) {
          const Index g = within.face[k];
          weight[k] = faces.area[g] * unit * close((faces.centroid[g] - faces.centroid[f]).squaredNorm());
        }
      }
  });
  return weight;
}

Array<Vec3> filter_normals(const FaceLists& within, const Array<double>& weight, const Array<Vec3>& guide,
                           const Array<Vec3>& normal, double range_sigma, Job& job) {
  const RangeWeight similar(range_sigma);
  Array<Vec3> filtered(normal.size());
  job.parallel(normal.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const Vec3 g = guide[f];
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = within.begin[f]; k < within.begin[f + 1]; ++k) {
          const Index j = within.face[k];
          sum += weight[k] * similar((guide[j] - g).squaredNorm()) * normal[j];
        }
        const double length = sum.norm();
        filtered[f] = length > no_direction ? Vec3(sum / length) : normal[f];
      }
  });
  return filtered;
}

}  // namespace vcg_core::detail
