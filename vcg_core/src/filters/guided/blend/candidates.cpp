// SPDX-License-Identifier: GPL-3.0-or-later
#include "candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "../face_geometry.h"
#include "../faces_around.h"
#include "../four_normals.h"
#include "../mean_normals.h"
#include "../normal_filter.h"
#include "../vertex_update.h"
#include "band_limits.h"
#include "job.h"
#include "polled_copy.h"

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

Array<PackedNormal> packed(const Array<UnitNormal>& normal, Job& job) {
  Array<PackedNormal> small(normal.size());
  for_each(normal.size(), job, [&](std::size_t f) { small[f] = packed(normal[f]); });
  return small;
}

/// @param position  as area_vector() has it
template <class Positions>
Array<PackedNormal> face_normals(const MeshArrays& mesh, const Positions& position, Job& job) {
  Array<PackedNormal> normal(mesh.face.size());
  for_each(normal.size(), job,
           [&](std::size_t f) { normal[f] = packed(in_single(direction_of_face(area_vector(mesh, position, f)))); });
  return normal;
}

/// The places of vertices that are displaced.
struct Displaced {
  const Array<Vec3>& position;
  const Array<Eigen::Vector3f>& displacement;

  Vec3 operator[](Index v) const { return position[v] + displacement[v].cast<double>(); }
};

/// Means over the neighbourhood by closeness and area.
class NeighbourhoodMean {
 public:
  /// @param area  of the faces for vertices at `position`
  NeighbourhoodMean(const CoarseResult& coarse, const Array<Vec3>& position, const Array<double>& area, Job& job)
      : within_(coarse.within),
        weight_(closeness_weights(coarse.within, coarse.mesh, position, area, coarse.spacing, coarse.settings.closeness,
                                  job)),
        job_(job) {}

  Array<PackedNormal> of_normals(const Array<PackedNormal>& normal, int times = 1) const {
    Array<PackedNormal> mean = mean_of_neighbourhoods(within_, weight_, normal, job_);
    for (int time = 1; time < times; ++time) mean = mean_of_neighbourhoods(within_, weight_, mean, job_);
    return mean;
  }

  /// Bilateral mean of `normal` by the differences of `guide`.
  Array<PackedNormal> guided(const Array<PackedNormal>& guide, const Array<PackedNormal>& normal,
                             double range_sigma) const {
    return filter_normals(within_, weight_, guide, normal, range_sigma, job_);
  }

  Array<PackedNormal> bilateral(const Array<PackedNormal>& normal, double range_sigma, int rounds) const {
    Array<PackedNormal> filtered = guided(normal, normal, range_sigma);
    for (int round = 1; round < rounds; ++round) filtered = guided(filtered, filtered, range_sigma);
    return filtered;
  }

  using FourNumbers = std::array<PackedNumber, 4>;

  /// Means of four values at once, three times over.
  Array<FourNumbers> of_values(Array<FourNumbers> value) const {
    Array<FourNumbers> mean(value.size());
    for (int time = 0; time < 3; ++time) {
      job_.parallel(within_.blocks(), grain / FaceLists::block_size, Loop::minor, [&](Chunks& chunks) {
        std::vector<Eigen::Vector4f> values;
        while (chunks.next())
          for (std::size_t b = chunks.begin(); b < chunks.end(); ++b) mean_in_block(b, value, values, mean);
      });
      value.swap(mean);
    }
    return value;
  }

 private:
  void mean_in_block(std::size_t b, const Array<FourNumbers>& value, std::vector<Eigen::Vector4f>& values,
                     Array<FourNumbers>& mean) const {
    const FaceLists::Block& lists = within_.block(b);
    gather(lists, values, [&](std::size_t f) {
      const FourNumbers& four = value[f];
      return Eigen::Vector4f(four[0].value(), four[1].value(), four[2].value(), four[3].value());
    });
    for_each_list(lists, [&](std::size_t i, std::size_t first, std::size_t length) {
      const std::uint16_t* const place = lists.entry.data() + first;
      const std::uint16_t* const weight = weight_.data() + lists.first_entry + first;
      Eigen::Vector4f sum = Eigen::Vector4f::Zero();
      float total = 0;
      for (std::size_t k = 0; k < length; ++k) {
        sum += static_cast<float>(weight[k]) * values[place[k]];
        total += static_cast<float>(weight[k]);
      }
      sum = total > 0 ? Eigen::Vector4f(sum / total) : values[i];
      for (std::size_t k = 0; k < 4; ++k) mean[lists.first + i][k] = PackedNumber(sum[static_cast<int>(k)]);
    });
  }

  const FaceLists& within_;
  ListWeights weight_;
  Job& job_;
};

/// A sum of normals by area.
class NormalsByArea {
 public:
  /// @param vector  a normal times its area, or what is proportional to it
  void add(const Vec3& vector, double area) {
    sum_ += vector;
    total_ += area;
  }
  /// sqrt(1 - length of the mean unit normal), which grows with the angle between them.
  PackedNumber spread() const {
    return PackedNumber(total_ > 0 ? static_cast<float>(std::sqrt(std::max(0.0, 1 - sum_.norm() / total_))) : 0);
  }

 private:
  Vec3 sum_ = Vec3::Zero();
  double total_ = 0;
};

/// Normals of the faces near a stretch of faces, which are unpacked at once.
class NormalsNear {
 public:
  explicit NormalsNear(const Array<PackedNormal>& normal) : normal_(normal) {}

  void begin(std::size_t first, std::size_t end) {
    first_ = first;
    stretch_.resize(end - first);
    unpack(normal_.data() + first, stretch_.size(), stretch_.data());
  }

  Vec3 operator[](std::size_t f) const {
    if (f - first_ < stretch_.size()) return in_double(stretch_[f - first_]);
    UnitNormal far;
    unpack(&normal_[f], 1, &far);
    return in_double(far);
  }

 private:
  const Array<PackedNormal>& normal_;
  std::size_t first_ = 0;
  std::vector<UnitNormal> stretch_;
};

/// How far the normals of the faces around each face spread: those of two filtered ones, with areas after filtering,
/// and the noisy ones with theirs.
void add_spreads(const CoarseResult& coarse, const Array<PackedNormal>& filtered, const Array<PackedNormal>& finer,
                 const Array<double>& area, Job& job, Candidates& candidates) {
  const Array<Index> across = faces_across(coarse.mesh, job);
  Array<PackedNumber> spread[3];
  for (Array<PackedNumber>& one : spread) one.resize(area.size());
  job.parallel(area.size(), grain, Loop::minor, [&](Chunks& chunks) {
    FacesAround around(coarse.mesh, across);
    NormalsNear filtered_near(filtered), finer_near(finer);
    while (chunks.next()) {
      around.forget_all();
      filtered_near.begin(chunks.begin(), chunks.end());
      finer_near.begin(chunks.begin(), chunks.end());
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        NormalsByArea of_filtered, of_finer, of_noisy;
        for (const Index g : around.find(static_cast<Index>(f))) {
          of_filtered.add(area[g] * filtered_near[g], area[g]);
          of_finer.add(area[g] * finer_near[g], area[g]);
          const Vec3 noisy = area_vector(coarse.mesh, coarse.noisy, g);
          of_noisy.add(noisy, noisy.norm());
        }
        spread[0][f] = of_filtered.spread();
        spread[1][f] = of_finer.spread();
        spread[2][f] = of_noisy.spread();
      }
    }
  });
  for (Array<PackedNumber>& one : spread) candidates.scalar.push_back(std::move(one));
}

void add_scalars(const CoarseResult& coarse, Job& job, Candidates& candidates) {
  const double e = coarse.mesh.topology.average_edge_length;
  const double scale = coarse.settings.noise_scale;
  Array<PackedNumber> noise(coarse.spacing.size()), size(coarse.spacing.size());
  for_each(noise.size(), job, [&](std::size_t f) {
    double sum = 0;
    for (const Index v : coarse.mesh.face[f]) sum += coarse.noise.deviation[v];
    // 0.6 spacings are an edge.
    noise[f] = PackedNumber(static_cast<float>(std::sqrt(scale * 0.2 * sum / coarse.spacing[f])));
    size[f] = PackedNumber(static_cast<float>(coarse.spacing[f] / (coarse.spacing[f] + 0.6 * e)));
  });
  candidates.scalar.push_back(std::move(noise));
  candidates.scalar.push_back(std::move(size));
}

using Pair = std::array<std::size_t, 2>;

/// Calls use(f, distance) for each face.
template <class Use>
void measure_distances(const Array<PackedNormal>& a, const Array<PackedNormal>& b, Job& job, const Use& use) {
  job.parallel(a.size(), grain, Loop::minor, [&](Chunks& chunks) {
    alignas(sizeof(Quad)) float distance[4];
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); f += 4) {
        const std::size_t count = std::min<std::size_t>(4, chunks.end() - f);
        sqrt(squared_distances(unpacked(&a[f], count), unpacked(&b[f], count))).store(distance);
        for (std::size_t k = 0; k < count; ++k) use(f + k, distance[k]);
      }
  });
}

/// Differences between candidates around the face, which tell more of noise and shape than those at the face alone.
/// Some at a time, so that they take little memory.
void add_context(const NeighbourhoodMean& mean, const std::vector<Pair>& pairs, Job& job, Candidates& candidates) {
  using FourNumbers = NeighbourhoodMean::FourNumbers;
  constexpr std::size_t at_a_time = std::tuple_size_v<FourNumbers>;
  Array<FourNumbers> difference(candidates.normal.front().size());
  for (std::size_t first = 0; first < pairs.size(); first += at_a_time) {
    const std::size_t count = std::min(at_a_time, pairs.size() - first);
    for (std::size_t p = 0; p < count; ++p)
      measure_distances(candidates.normal[pairs[first + p][0]], candidates.normal[pairs[first + p][1]], job,
                        [&](std::size_t f, float distance) { difference[f][p] = PackedNumber(distance); });
    difference = mean.of_values(std::move(difference));
    for (std::size_t p = 0; p < count; ++p) {
      Array<PackedNumber> one(difference.size());
      for_each(one.size(), job, [&](std::size_t f) { one[f] = difference[f][p]; });
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
std::vector<Array<PackedNormal>> band_limited_normals(const MeshArrays& mesh, const Array<Vec3>& position,
                                                      const std::vector<double>& cut_offs, Job& job) {
  std::vector<Array<PackedNormal>> normals;
  for (Array<Eigen::Vector3f>& displacement : band_limit_displacements(mesh, position, cut_offs, job)) {
    normals.push_back(face_normals(mesh, Displaced{position, displacement}, job));
    release(displacement);
  }
  return normals;
}

Array<double> face_areas(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  Array<double> area(mesh.face.size());
  for_each(area.size(), job, [&](std::size_t f) { area[f] = area_vector(mesh, position, f).norm() / 2; });
  return area;
}

void add_normals(std::vector<Array<PackedNormal>> normals, Candidates& candidates) {
  for (Array<PackedNormal>& normal : normals) candidates.normal.push_back(std::move(normal));
}

}  // namespace

double median_residual(const CoarseResult& coarse, Job& job) {
  return median_size(coarse, residuals(coarse, mean_normals(coarse.mesh, coarse.faces.normal, job), job), job);
}

Candidates first_candidates(CoarseResult& coarse, Job& job) {
  Candidates candidates;
  const auto add = [&](Array<PackedNormal> one) { candidates.normal.push_back(std::move(one)); };
  enum : std::size_t { raw, filtered, fine, finer, mean_of_raw, guided = 6 };  // places of some
  const auto& normal = candidates.normal;
  add(face_normals(coarse.mesh, coarse.noisy, job));
  add(packed(coarse.faces.normal, job));
  // The low-passes take the most memory: without the coarse faces, and before the weights of the neighbourhoods come.
  Array<Vec3> held = without_outliers(coarse, job);
  release(coarse.faces.normal, coarse.faces.area);
  std::vector<Array<PackedNormal>> low = band_limited_normals(coarse.mesh, held, first_cut_offs, job);
  release(held);
  Array<double> area = face_areas(coarse.mesh, coarse.position, job);
  const NeighbourhoodMean mean(coarse, coarse.position, area, job);
  release(coarse.position);
  const double range = coarse.settings.fine_range;
  add(mean.bilateral(normal[filtered], range, 4));
  add(mean.bilateral(normal[fine], range, 12));
  add_spreads(coarse, normal[filtered], normal[finer], area, job, candidates);
  release(area);
  add(mean.of_normals(normal[raw]));
  add(mean.of_normals(normal[mean_of_raw], 2));
  add(mean.guided(normal[finer], normal[raw], range));
  add(mean.guided(normal[finer], mean.guided(normal[finer], normal[guided], 4. / 3 * range), 4. / 3 * range));
  add_normals(std::move(low), candidates);

  add_scalars(coarse, job, candidates);
  add_context(mean, {{0, 1}, {0, 3}, {1, 3}, {3, 7}, {0, 9}, {3, 10}, {10, 12}, {12, 13}}, job, candidates);
  return candidates;
}

Candidates second_candidates(const CoarseResult& coarse, Array<UnitNormal> first_blend, Job& job) {
  constexpr int updates = 10;
  Array<Vec3> position = polled_copy(coarse.noisy, job);
  update_positions(coarse.mesh, first_blend, coarse.movable, updates, coarse.settings, position, job);
  Candidates candidates;
  const auto add = [&](Array<PackedNormal> one) { candidates.normal.push_back(std::move(one)); };
  enum : std::size_t { raw, blended, fine, mean_of_blended = 5, guided = 7 };  // places of some
  const auto& normal = candidates.normal;
  add(face_normals(coarse.mesh, coarse.noisy, job));
  add(packed(first_blend, job));
  release(first_blend);
  std::vector<Array<PackedNormal>> low = band_limited_normals(coarse.mesh, position, second_cut_offs, job);
  Array<PackedNormal> moved = face_normals(coarse.mesh, position, job);
  Array<double> area = face_areas(coarse.mesh, position, job);
  const NeighbourhoodMean mean(coarse, position, area, job);
  release(position);
  const double range = coarse.settings.fine_range;
  add(mean.bilateral(normal[blended], range, 3));
  add_spreads(coarse, normal[blended], normal[fine], area, job, candidates);
  release(area);
  add(mean.bilateral(normal[fine], range, 7));
  add(mean.bilateral(normal[blended], range / 2, 6));
  add(mean.of_normals(normal[blended]));
  add(mean.of_normals(normal[mean_of_blended], 2));
  add(mean.guided(normal[blended], normal[raw], 2. / 3 * range));
  add(mean.guided(normal[blended], mean.guided(normal[blended], normal[guided], range), range));
  add(std::move(moved));
  add_normals(std::move(low), candidates);

  add_scalars(coarse, job, candidates);
  add_context(mean, {{0, 1}, {1, 3}, {1, 8}, {1, 10}, {1, 11}, {0, 10}}, job, candidates);
  return candidates;
}

}  // namespace vcg_core::detail
