// SPDX-License-Identifier: GPL-3.0-or-later
#include "normal_filter.h"

#include <algorithm>
#include <cmath>

#include "job.h"
#include "range_weight.h"
#include "simd/four_floats.h"

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
  const RangeWeight<float> close(closeness);  // of distances in spacings
  Array<float> weight(within.face.size());
  job.parallel(spacing.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const double unit = 1 / (spacing[f] * spacing[f]);  // areas as multiples of it neither over- nor underflow
        const Index* face = within.first(f);
        float* const of_face = weight.data() + within.begin[f];
        const std::size_t count = within.begin[f + 1] - within.begin[f];
        // Two loops, as compilers turn the second one into vectors.
        for (std::size_t k = 0; k < count; ++k)
          of_face[k] = static_cast<float>((faces.centroid[face[k]] - faces.centroid[f]).squaredNorm() * unit);
        for (std::size_t k = 0; k < count; ++k)
          of_face[k] = static_cast<float>(faces.area[face[k]] * unit) * close(of_face[k]);
      }
  });
  return weight;
}

namespace {

/// Four normals, one coordinate of all in a register.
struct FourNormals {
  FourFloats x, y, z;
};

FourNormals four_normals(const Array<UnitNormal>& normal, const Index* face) {
  const auto load = [&](int k) { return FourFloats::at(normal[face[k]].data()); };
  FourFloats a = load(0), b = load(1), c = load(2), d = load(3);
  transpose(a, b, c, d);
  return {a, b, c};
}

FourFloats squared_distances(const FourNormals& a, const FourNormals& b) {
  const FourFloats x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

/// A weighted sum of normals, four terms at a time.
class NormalSum {
 public:
  void add(FourFloats weight, const FourNormals& normal) {
    x_ += weight * normal.x;
    y_ += weight * normal.y;
    z_ += weight * normal.z;
    total_ += weight;
  }

  UnitNormal direction(const UnitNormal& otherwise) const {
    FourFloats x = x_, y = y_, z = z_, total = total_;
    transpose(x, y, z, total);
    alignas(sizeof(Quad)) float sum[4];
    quad::store(sum, (x + y + (z + total)).value);
    return direction_of(UnitNormal(sum[0], sum[1], sum[2], 0), sum[3], otherwise);
  }

 private:
  FourFloats x_ = 0, y_ = 0, z_ = 0, total_ = 0;
};

/// Calls body(faces, weights) for the neighbours of a face, four at a time; at the end some have no weight.
template <class Body>
void visit_by_fours(const Index* face, const float* weight, std::size_t count, const Body& body) {
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) body(face + k, quad::set(weight[k], weight[k + 1], weight[k + 2], weight[k + 3]));
  if (k == count) return;
  Index last_face[4];
  float last_weight[4];
  for (std::size_t i = 0; i < 4; ++i) {
    last_face[i] = face[std::min(k + i, count - 1)];
    last_weight[i] = k + i < count ? weight[k + i] : 0;
  }
  body(last_face, quad::set(last_weight[0], last_weight[1], last_weight[2], last_weight[3]));
}

/// Gives each normal the direction of sum_of(f, faces, weights, count) over its neighbours.
template <class Sum>
Array<UnitNormal> filter_each(const FaceLists& within, const Array<float>& weight, const Array<UnitNormal>& normal,
                              Job& job, const Sum& sum_of) {
  Array<UnitNormal> filtered(normal.size());
  job.parallel(normal.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const std::size_t begin = within.begin[f];
        const NormalSum sum = sum_of(f, within.face.data() + begin, weight.data() + begin, within.begin[f + 1] - begin);
        filtered[f] = sum.direction(normal[f]);
      }
  });
  return filtered;
}

}  // namespace

Array<UnitNormal> filter_normals(const FaceLists& within, const Array<float>& weight, const Array<UnitNormal>& guide,
                                 const Array<UnitNormal>& normal, double range_sigma, Job& job) {
  const RangeWeight<float> similar(range_sigma);
  const bool guides_itself = &guide == &normal;
  return filter_each(within, weight, normal, job,
                     [&](std::size_t f, const Index* face, const float* close, std::size_t count) {
                       NormalSum sum;
                       const FourNormals here{guide[f][0], guide[f][1], guide[f][2]};
                       visit_by_fours(face, close, count, [&](const Index* four, FourFloats closeness) {
                         const FourNormals guides = four_normals(guide, four);
                         sum.add(closeness * similar(squared_distances(guides, here)),
                                 guides_itself ? guides : four_normals(normal, four));
                       });
                       return sum;
                     });
}

Array<UnitNormal> mean_of_neighbourhoods(const FaceLists& within, const Array<float>& weight,
                                         const Array<UnitNormal>& normal, Job& job) {
  return filter_each(within, weight, normal, job,
                     [&](std::size_t /*f*/, const Index* face, const float* close, std::size_t count) {
                       NormalSum sum;
                       visit_by_fours(face, close, count, [&](const Index* four, FourFloats closeness) {
                         sum.add(closeness, four_normals(normal, four));
                       });
                       return sum;
                     });
}

}  // namespace vcg_core::detail
