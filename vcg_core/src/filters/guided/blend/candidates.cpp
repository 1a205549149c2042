// SPDX-License-Identifier: GPL-3.0-or-later
#include "candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../mean_normals.h"
#include "../normal_filter.h"
#include "../vertex_update.h"
#include "band_limits.h"
#include "job.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 2048;

/// Cut-offs of the first stage's low-passes: waves of 3.2, 4.7, 6.8, 11, 18 and 35 edges.
const std::vector<double> first_cut_offs = {1.4, 0.95, 0.65, 0.4, 0.25, 0.125};
const std::vector<double> second_cut_offs = {1.0, 0.5};

/// Residuals are held to this many standard deviations before the low-passes, so that a vertex far off does not leave a
/// bump.
constexpr double outlier = 2.5;
constexpr double deviation_of_median = 1.4826;

/// Calls body(f) for each index below `count`, in parallel.
template <class Body>
void for_each(std::size_t count, Job& job, const Body& body) {
  job.parallel(count, grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t i = chunks.begin(); i < chunks.end(); ++i) body(i);
  });
}

/// Gives the memory of arrays back before others are made.
template <class... Arrays>
void release(Arrays&... arrays) {
  (Arrays().swap(arrays), ...);
}

Array<PackedNormal> packed(const Array<UnitNormal>& normal, Job& job) {
  Array<PackedNormal> small(normal.size());
  for_each(normal.size(), job, [&](std::size_t f) { small[f] = PackedNormal(normal[f].head<3>()); });
  return small;
}

/// Measured anew in each stage, so that they need not be kept from the first to the second.
Array<UnitNormal> noisy_normals(const CoarseResult& coarse, Job& job) {
  Array<UnitNormal> normal(coarse.mesh.face.size());
  for_each(normal.size(), job,
           [&](std::size_t f) { normal[f] = in_single(direction_of_face(area_vector(coarse.mesh, coarse.noisy, f))); });
  return normal;
}

Array<PackedNormal> packed_face_normals(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  Array<PackedNormal> small(mesh.face.size());
  for_each(small.size(), job, [&](std::size_t f) {
    small[f] = PackedNormal(direction_of_face(area_vector(mesh, position, f)).cast<float>());
  });
  return small;
}

/// Means over the neighbourhood by closeness and area.
class NeighbourhoodMean {
 public:
  NeighbourhoodMean(const CoarseResult& coarse, const FaceGeometry& faces, Job& job)
      : within_(coarse.within),
        weight_(closeness_weights(coarse.within, faces, coarse.spacing, coarse.settings.closeness, job)),
        job_(job) {}

  Array<UnitNormal> of_normals(const Array<UnitNormal>& normal) const {
    return mean_of_neighbourhoods(within_, weight_, normal, job_);
  }

  /// Bilateral mean of `normal` by the differences of `guide`.
  Array<UnitNormal> guided(const Array<UnitNormal>& guide, const Array<UnitNormal>& normal, double range_sigma) const {
    return filter_normals(within_, weight_, guide, normal, range_sigma, job_);
  }

  Array<UnitNormal> bilateral(Array<UnitNormal> normal, double range_sigma, int rounds) const {
    for (int round = 0; round < rounds; ++round) normal = guided(normal, normal, range_sigma);
    return normal;
  }

  /// Means of four values at once, three times over.
  Array<Eigen::Vector4f> of_values(Array<Eigen::Vector4f> value) const {
    Array<Eigen::Vector4f> mean(value.size());
    for (int time = 0; time < 3; ++time) {
      for_each(value.size(), job_, [&](std::size_t f) {
        Eigen::Vector4f sum = Eigen::Vector4f::Zero();
        float total = 0;
        for (std::size_t k = within_.begin[f]; k < within_.begin[f + 1]; ++k) {
          sum += weight_[k] * value[within_.face[k]];
          total += weight_[k];
        }
        mean[f] = total > 0 ? Eigen::Vector4f(sum / total) : value[f];
      });
      value.swap(mean);
    }
    return value;
  }

 private:
  const FaceLists& within_;
  Array<float> weight_;
  Job& job_;
};

/// A sum of normals by area.
class NormalsByArea {
 public:
  void add(const UnitNormal& normal, double area) {
    sum_ += area * normal.head<3>().cast<double>();
    total_ += area;
  }
  /// sqrt(1 - length of the mean unit normal), which grows with the angle between them.
  float spread() const {
    return total_ > 0 ? static_cast<float>(std::sqrt(std::max(0.0, 1 - sum_.norm() / total_))) : 0;
  }

 private:
  Vec3 sum_ = Vec3::Zero();
  double total_ = 0;
};

/// How far the normals of the faces around each face spread: those of two filtered ones, with areas after filtering,
/// and the noisy ones with theirs.
void add_spreads(const CoarseResult& coarse, const Array<UnitNormal>& noisy, const Array<UnitNormal>& filtered,
                 const Array<UnitNormal>& finer, const Array<double>& area, Job& job, Candidates& candidates) {
  const Array<Index> across = faces_across(coarse.mesh, job);
  Array<float> spread[3] = {Array<float>(area.size()), Array<float>(area.size()), Array<float>(area.size())};
  job.parallel(area.size(), grain, Loop::minor, [&](Chunks& chunks) {
    FacesAround around(coarse.mesh, across);
    while (chunks.next()) {
      around.forget_all();
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        NormalsByArea of_filtered, of_finer, of_noisy;
        for (const Index g : around.find(static_cast<Index>(f))) {
          of_filtered.add(filtered[g], area[g]);
          of_finer.add(finer[g], area[g]);
          of_noisy.add(noisy[g], area_vector(coarse.mesh, coarse.noisy, g).norm() / 2);
        }
        spread[0][f] = of_filtered.spread();
        spread[1][f] = of_finer.spread();
        spread[2][f] = of_noisy.spread();
      }
    }
  });
  for (Array<float>& one : spread) candidates.scalar.push_back(std::move(one));
}

void add_scalars(const CoarseResult& coarse, Job& job, Candidates& candidates) {
  const double e = coarse.mesh.topology.average_edge_length;
  const double scale = coarse.settings.noise_scale;
  Array<float> noise(coarse.spacing.size()), size(coarse.spacing.size());
  for_each(noise.size(), job, [&](std::size_t f) {
    double sum = 0;
    for (const Index v : coarse.mesh.face[f]) sum += coarse.noise.deviation[v];
    noise[f] = static_cast<float>(std::sqrt(scale * 0.2 * sum / coarse.spacing[f]));  // 0.6 spacings are an edge
    size[f] = static_cast<float>(coarse.spacing[f] / (coarse.spacing[f] + 0.6 * e));
  });
  candidates.scalar.push_back(std::move(noise));
  candidates.scalar.push_back(std::move(size));
}

using Pair = std::array<std::size_t, 2>;

/// Not Eigen's norm: on ARM that adds three floats in another order, which ends in other bits.
float distance(const Vec3f& a, const Vec3f& b) {
  const Vec3f d = a - b;
  return std::sqrt(d[0] * d[0] + (d[1] * d[1] + d[2] * d[2]));
}

/// Differences between candidates around the face, which tell more of noise and shape than those at the face alone.
/// Some at a time, so that they take little memory.
void add_context(const NeighbourhoodMean& mean, const std::vector<Pair>& pairs, Job& job, Candidates& candidates) {
  constexpr std::size_t at_a_time = 4;
  Array<Eigen::Vector4f> difference(candidates.normal.front().size());
  for (std::size_t first = 0; first < pairs.size(); first += at_a_time) {
    const std::size_t count = std::min(at_a_time, pairs.size() - first);
    for_each(difference.size(), job, [&](std::size_t f) {
      difference[f].setZero();
      for (std::size_t p = 0; p < count; ++p) {
        const auto [a, b] = pairs[first + p];
        difference[f][static_cast<int>(p)] =
            distance(candidates.normal[a][f].vector(), candidates.normal[b][f].vector());
      }
    });
    difference = mean.of_values(std::move(difference));
    for (std::size_t p = 0; p < count; ++p) {
      Array<float> one(difference.size());
      for_each(one.size(), job, [&](std::size_t f) { one[f] = difference[f][static_cast<int>(p)]; });
      candidates.scalar.push_back(std::move(one));
    }
  }
}

/// How far the noisy vertices are from the coarse ones along the normals.
Array<double> residuals(const CoarseResult& coarse, const Array<Vec3>& normal, Job& job) {
  Array<double> residual(coarse.mesh.size());
  for_each(normal.size(), job,
           [&](std::size_t v) { residual[v] = (coarse.noisy[v] - coarse.position[v]).dot(normal[v]); });
  return residual;
}

double median_size(const CoarseResult& coarse, Array<double> residual, Job& job) {
  for_each(residual.size(), job, [&](std::size_t v) { residual[v] = std::abs(residual[v]); });
  return coarse.medians.of_vertices(residual);
}

/// The noisy positions, where they are far from the coarse ones along the normal brought nearer.
Array<Vec3> without_outliers(const CoarseResult& coarse, Job& job) {
  const Array<Vec3> normal = mean_normals(coarse.mesh, coarse.faces.normal, job);
  const Array<double> residual = residuals(coarse, normal, job);
  const double limit = outlier * deviation_of_median * median_size(coarse, residual, job);
  Array<Vec3> position(coarse.mesh.size());
  for_each(position.size(), job, [&](std::size_t v) {
    const double held = std::clamp(residual[v], -limit, limit);
    position[v] = coarse.noisy[v] + (held - residual[v]) * normal[v];
  });
  return position;
}

/// The normals of band-limited positions, one array for each cut-off.
std::vector<Array<PackedNormal>> band_limited_normals(const CoarseResult& coarse, const Array<Vec3>& position,
                                                      const std::vector<double>& cut_offs, Job& job) {
  std::vector<Array<PackedNormal>> normals;
  for (Array<Vec3>& low : band_limited_positions(coarse.mesh, coarse.rings, position, cut_offs, job)) {
    normals.push_back(packed_face_normals(coarse.mesh, low, job));
    release(low);
  }
  return normals;
}

void add_normals(std::vector<Array<PackedNormal>> normals, Candidates& candidates) {
  for (Array<PackedNormal>& normal : normals) candidates.normal.push_back(std::move(normal));
}

}  // namespace

double median_residual(const CoarseResult& coarse, Job& job) {
  return median_size(coarse, residuals(coarse, mean_normals(coarse.mesh, coarse.faces.normal, job), job), job);
}

Candidates first_candidates(CoarseResult& coarse, Job& job) {
  // First, so that the memory of the positions is free again when the weights of the neighbourhoods come.
  std::vector<Array<PackedNormal>> low =
      band_limited_normals(coarse, without_outliers(coarse, job), first_cut_offs, job);
  release(coarse.position);
  const NeighbourhoodMean mean(coarse, coarse.faces, job);
  release(coarse.faces.centroid);
  const double range = coarse.settings.fine_range;
  Array<UnitNormal> raw = noisy_normals(coarse, job);
  Array<UnitNormal> filtered = in_single(coarse.faces.normal, job);
  release(coarse.faces.normal);
  Candidates candidates;
  const auto add = [&](const Array<UnitNormal>& normal) { candidates.normal.push_back(packed(normal, job)); };
  add(raw);
  add(filtered);
  Array<UnitNormal> fine = mean.bilateral(filtered, range, 4);
  add(fine);
  fine = mean.bilateral(std::move(fine), range, 12);
  add(fine);
  add_spreads(coarse, raw, filtered, fine, coarse.faces.area, job, candidates);
  release(filtered, coarse.faces.area);
  Array<UnitNormal> normal = mean.of_normals(raw);
  add(normal);
  add(mean.of_normals(mean.of_normals(normal)));
  normal = mean.guided(fine, raw, range);
  release(raw);
  add(normal);
  normal = mean.guided(fine, normal, 4. / 3 * range);
  add(mean.guided(fine, normal, 4. / 3 * range));
  release(fine, normal);
  add_normals(std::move(low), candidates);

  add_scalars(coarse, job, candidates);
  add_context(mean, {{0, 1}, {0, 3}, {1, 3}, {3, 7}, {0, 9}, {3, 10}, {10, 12}, {12, 13}}, job, candidates);
  return candidates;
}

Candidates second_candidates(const CoarseResult& coarse, Array<UnitNormal> blended, Job& job) {
  constexpr int updates = 10;
  Array<Vec3> position = coarse.noisy;
  update_positions(coarse.mesh, in_double(blended, job), coarse.movable, updates, coarse.settings, position, job);
  FaceGeometry faces;
  std::vector<Array<PackedNormal>> low = band_limited_normals(coarse, position, second_cut_offs, job);
  Array<PackedNormal> moved = packed_face_normals(coarse.mesh, position, job);
  faces.measure(coarse.mesh, position, job);
  release(position, faces.normal);
  const NeighbourhoodMean mean(coarse, faces, job);
  release(faces.centroid);
  const double range = coarse.settings.fine_range;
  Array<UnitNormal> raw = noisy_normals(coarse, job);
  Candidates candidates;
  const auto add = [&](const Array<UnitNormal>& normal) { candidates.normal.push_back(packed(normal, job)); };
  add(raw);
  add(blended);
  Array<UnitNormal> fine = mean.bilateral(blended, range, 3);
  add(fine);
  add_spreads(coarse, raw, blended, fine, faces.area, job, candidates);
  release(faces.area);
  add(mean.bilateral(fine, range, 7));
  add(mean.bilateral(blended, range / 2, 6));
  release(fine);
  Array<UnitNormal> normal = mean.of_normals(blended);
  add(normal);
  add(mean.of_normals(mean.of_normals(normal)));
  normal = mean.guided(blended, raw, 2. / 3 * range);
  release(raw);
  add(normal);
  add(mean.guided(blended, mean.guided(blended, normal, range), range));
  release(blended, normal);
  candidates.normal.push_back(std::move(moved));
  add_normals(std::move(low), candidates);

  add_scalars(coarse, job, candidates);
  add_context(mean, {{0, 1}, {1, 3}, {1, 8}, {1, 10}, {1, 11}, {0, 10}}, job, candidates);
  return candidates;
}

}  // namespace vcg_core::detail
