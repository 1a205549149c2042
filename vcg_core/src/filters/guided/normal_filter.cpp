// SPDX-License-Identifier: GPL-3.0-or-later
#include "normal_filter.h"

#include <cmath>
#include <vector>

#include "job.h"
#include "range_weight.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 1024;

/// Sums of normals that are shorter, as a share of their weights, have no direction: they cancel each other.
constexpr float no_direction = 1e-5F;

UnitNormal direction_of(const UnitNormal& sum, float total, const UnitNormal& otherwise) {
  const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  return length > no_direction * total ? UnitNormal(sum / length) : otherwise;
}

}  // namespace

Array<float> closeness_weights(const FaceLists& within, const FaceGeometry& faces, const Array<double>& spacing,
                               double closeness, Job& job) {
  Array<float> weight(within.face.size());
  job.parallel(spacing.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const RangeWeight<double> close(closeness * spacing[f]);
        const double unit = 1 / (spacing[f] * spacing[f]);  // areas as multiples of it neither over- nor underflow
        for (std::size_t k = within.begin[f]; k < within.begin[f + 1]; ++k) {
          const Index g = within.face[k];
          weight[k] =
              static_cast<float>(faces.area[g] * unit * close((faces.centroid[g] - faces.centroid[f]).squaredNorm()));
        }
      }
  });
  return weight;
}

Array<UnitNormal> filter_normals(const FaceLists& within, const Array<float>& weight, const Array<UnitNormal>& guide,
                                 const Array<UnitNormal>& normal, double range_sigma, Job& job) {
  const RangeWeight<float> similar(range_sigma);
  Array<UnitNormal> filtered(normal.size());
  job.parallel(normal.size(), grain, Loop::minor, [&](Chunks& chunks) {
    std::vector<float> product;  // of both weights, for one face; a loop by itself, which compilers turn into vectors
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const Index* face = within.first(f);
        const float* close = weight.data() + within.begin[f];
        const std::size_t count = within.begin[f + 1] - within.begin[f];
        if (product.size() < count) product.resize(count);
        const UnitNormal g = guide[f];
        for (std::size_t k = 0; k < count; ++k) {
          const UnitNormal d = guide[face[k]] - g;
          const UnitNormal squared = d.cwiseProduct(d);
          product[k] = squared[0] + squared[1] + squared[2];
        }
        for (std::size_t k = 0; k < count; ++k) product[k] = close[k] * similar(product[k]);
        UnitNormal sum = UnitNormal::Zero();
        float total = 0;
        for (std::size_t k = 0; k < count; ++k) {
          sum += product[k] * normal[face[k]];
          total += product[k];
        }
        filtered[f] = direction_of(sum, total, normal[f]);
      }
  });
  return filtered;
}

Array<UnitNormal> mean_of_neighbourhoods(const FaceLists& within, const Array<float>& weight,
                                         const Array<UnitNormal>& normal, Job& job) {
  Array<UnitNormal> mean(normal.size());
  job.parallel(normal.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        UnitNormal sum = UnitNormal::Zero();
        float total = 0;
        for (std::size_t k = within.begin[f]; k < within.begin[f + 1]; ++k) {
          sum += weight[k] * normal[within.face[k]];
          total += weight[k];
        }
        mean[f] = direction_of(sum, total, normal[f]);
      }
  });
  return mean;
}

}  // namespace vcg_core::detail
