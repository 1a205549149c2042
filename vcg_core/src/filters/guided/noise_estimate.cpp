// SPDX-License-Identifier: GPL-3.0-or-later
#include "noise_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "job.h"
#include "polled_copy.h"
#include "ramp.h"
#include "ring_heights.h"
#include "told_whole.h"
#include "voxel_stairs.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;

/// Rings over which the evidence is averaged: about a hundred vertices, which give sigma to within a tenth.
constexpr int evidence_rings = 12;

/// Mean of max(0, -h m) over the mean of -h m for white noise, as measured on planes.
constexpr double opposed_part = 1.06;

/// What tells noise from shape around a vertex, and from where to where trust in the estimate rises or falls.
/// The share of the opposed products, a / (a + b): 0.93 for white noise on planes, 0.3 to 0.9 for noise of 0.1 to 0.3
/// on machine parts, less than 0.2 on nearly all clean models.
constexpr double opposed_from = 0.4;
constexpr double opposed_full = 0.6;
/// The share of them at vertices whose height no two neighbours have. Threads, gears and grooves alternate as noise
/// does, but run on along one direction: less than 0.5; noise of any kind has 0.65 to 0.9.
constexpr double unmatched_from = 0.55;
constexpr double unmatched_full = 0.7;
/// Mean squared difference in height from the second most similar neighbour, over the variance of the noise: 0.9 to 1.8
/// for noise of any kind, impulsive too; more where there are steps besides.
constexpr double jump_full = 1.8;
constexpr double jump_to = 2.2;
/// Squared mean of the opposed products over their mean square: 0.13 or more for noise, 0.04 or more where it is
/// impulsive; next to nothing where a few long edges among short ones outweigh all else.
constexpr double spread_from = 0.02;
constexpr double spread_full = 0.05;

/// Share of trusted vertices, and their number, from which the estimate counts for those around; below, it fades to 0.
constexpr double least_share = 0.03;
constexpr double full_share = 0.1;
constexpr double full_count = 64;

/// A few vertices of a clean mesh look noisy by chance. Their share of the whole mesh from which they are believed, and
/// from which they are in full.
constexpr double believed_from = 0.02;
constexpr double believed_full = 0.05;

/// Rings over which trusted vertices are looked for; where there are too few, all of the mesh count.
constexpr int testimony_rings = 24;

/// What one vertex, or several, tell. Products are those of a height and the mean height around it.
using Evidence = Eigen::Matrix<double, 7, 1>;
enum : int {
  opposed,    ///< negative products
  squares,    ///< their squares
  agreeing,   ///< positive products
  unmatched,  ///< negative products, as far as no two neighbours share the height
  expected,   ///< negative products that noise of standard deviation 1 would give
  jumps,      ///< squared differences from the height of the second most similar neighbour
  vertices
};

/// The smallest but one of the differences in height between v and its neighbours, whichever way its faces are turned.
double second_smallest_jump(const MeshArrays& mesh, const Array<double>& height, Index v) {
  const MeshTopology& topology = mesh.topology;
  double smallest = std::numeric_limits<double>::infinity();
  double second = smallest;
  Index nearest = v;
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s)
    for (const Index corner : {next_in_face(topology.star[s]), previous_in_face(topology.star[s])}) {
      const Index neighbor = vertex_of(mesh, corner);
      if (neighbor == nearest) continue;
      const double jump = std::abs(height[neighbor] - height[v]);
      if (jump < smallest) {
        second = smallest;
        smallest = jump;
        nearest = neighbor;
      } else {
        second = std::min(second, jump);
      }
    }
  return second;
}

/// By vertex; zero on borders, where half of the ring is missing, and on creases, where height is shape.
Array<Evidence> find_evidence(const MeshArrays& mesh, const RingMeans& rings, const Array<double>& height, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<double> inverse_valence(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) {
    inverse_valence[v] = 1.0 / std::max<Index>(1, topology.star_begin[v + 1] - topology.star_begin[v]);
  });
  Array<Evidence> evidence(mesh.size());
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        evidence[v].setZero();
        if (topology.border[v] || topology.is_on_crease(v) || topology.star_begin[v + 1] - topology.star_begin[v] < 3)
          continue;
        const double product = height[v] * rings.mean(height, v);
        const double of_ring = rings.mean(inverse_valence, v);
        // Covariance of h at the ends of an edge with two triangles: -1/k_u - 1/k_v + 2 / (k_u k_v).
        const double covariance = inverse_valence[v] + of_ring - 2 * inverse_valence[v] * of_ring;
        const double jump = second_smallest_jump(mesh, height, static_cast<Index>(v));
        evidence[v][opposed] = std::max(0.0, -product);
        evidence[v][squares] = evidence[v][opposed] * evidence[v][opposed];
        evidence[v][agreeing] = std::max(0.0, product);
        if (product < 0) evidence[v][unmatched] = -product * std::min(1.0, jump / std::abs(height[v]));
        evidence[v][expected] = opposed_part * std::max(0.0, covariance);
        evidence[v][jumps] = jump * jump;
        evidence[v][vertices] = 1;
      }
  });
  return evidence;
}

double variance_of(const Evidence& e) { return e[expected] > 0 ? e[opposed] / e[expected] : 0; }

/// Whether what is seen around a vertex is noise: from 0 to 1.
double trust_in(const Evidence& e) {
  if (!(e[opposed] > 0)) return 0;
  const double noise = ramp(e[opposed] / (e[opposed] + e[agreeing]), opposed_from, opposed_full);
  const double irregular = ramp(e[unmatched] / e[opposed], unmatched_from, unmatched_full);
  const double jump = e[jumps] / (e[vertices] * variance_of(e));
  const double spread = ramp(e[opposed] * e[opposed] / (e[squares] * e[vertices]), spread_from, spread_full);
  return noise * irregular * (1 - ramp(jump, jump_full, jump_to)) * spread;
}

/// What trusted vertices tell, each as far as it is trusted.
using Testimony = Eigen::Matrix<double, 4, 1>;
enum : int { trusted_opposed, trusted_expected, trusted, asked };

double variance_of(const Testimony& t) {
  return t[trusted_expected] > 0 ? t[trusted_opposed] / t[trusted_expected] : 0;
}

/// Whether there are enough trusted vertices among those that were asked: from 0 to 1.
double confidence_in(const Testimony& t) {
  return t[trusted] > 0 ? ramp(t[trusted] / t[asked], least_share, full_share) : 0;
}

double root_mean_square(const Array<double>& value, Job& job) {
  double sum = 0;
  job.serial(value.size(), [&](std::size_t v) { sum += value[v] * value[v]; });
  return std::sqrt(sum / static_cast<double>(value.size()));
}

/// By vertex.
Array<Testimony> find_testimony(const Array<Evidence>& own, const Array<Evidence>& around, Job& job) {
  Array<Testimony> testimony(own.size());
  job.serial(own.size(), [&](std::size_t v) {
    const double trust = own[v][vertices] > 0 ? trust_in(around[v]) : 0;
    testimony[v] = Testimony(trust * own[v][opposed], trust * own[v][expected], trust, own[v][vertices]);
  });
  return testimony;
}

GuidedWhole::Testimony named(const Testimony& t) {
  return {t[trusted_opposed], t[trusted_expected], t[trusted], t[asked]};
}

}  // namespace

NoiseEstimate told_noise(const GuidedWhole& whole) {
  const bool clear = whole.grid || whole.correlated;
  return {{}, whole.noise, clear ? 1 : NoiseByWhole(whole.testimony).evidence(), whole.correlated};
}

NoiseEstimate even_noise(const MeshArrays& mesh, double deviation) {
  NoiseEstimate noise;
  noise.deviation.assign(mesh.size(), deviation);
  noise.mean = deviation;
  noise.evidence = 1;
  return noise;
}

NoiseByWhole::NoiseByWhole(const GuidedWhole::Testimony& t) {
  const Testimony all(t.opposed, t.expected, t.trusted, t.asked);
  share_ = all[asked] > 0 ? all[trusted] / all[asked] : 0;
  believed_ = ramp(share_, believed_from, believed_full) * std::min(1.0, all[trusted] / full_count);
  of_all_ = believed_ * confidence_in(all) * variance_of(all);
}

double NoiseByWhole::variance(double by_vertex, double near_by, double confidence) const {
  const double share = believed_ * confidence;
  return std::min(by_vertex, share * near_by + (1 - share) * of_all_);
}

NoiseSeen look_for_noise(const MeshArrays& mesh, const RingMeans& rings, const Array<Vec3>& position, Job& job) {
  NoiseSeen seen;
  if (const auto stairs = find_voxel_stairs(mesh, job)) {
    seen.of_stairs = deviations_by_stairs(mesh, rings, *stairs, job);
    return seen;
  }
  Array<Testimony> testimony;
  seen.variance.resize(mesh.size());
  {
    const Array<Evidence> own = find_evidence(mesh, rings, ring_heights(mesh, rings, position, job), job);
    const Array<Evidence> around = low_pass(rings, polled_copy(own, job), evidence_rings, job);
    testimony = find_testimony(own, around, job);
    job.serial(mesh.size(), [&](std::size_t v) { seen.variance[v] = variance_of(around[v]); });
  }
  Testimony all = Testimony::Zero();
  job.serial(mesh.size(), [&](std::size_t v) {
    if (mesh.counted(v) > 0) all += testimony[v];
  });
  seen.testimony = named(all);
  testimony = low_pass(rings, std::move(testimony), testimony_rings, job);
  seen.near_by.resize(mesh.size());
  seen.confidence.resize(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) {
    seen.near_by[v] = variance_of(testimony[v]);
    seen.confidence[v] = confidence_in(testimony[v]);
  });
  return seen;
}

NoiseEstimate estimate_noise(const MeshArrays& mesh, const RingMeans& rings, const Array<Vec3>& position, Job& job) {
  const GuidedWhole* const told = told_whole(mesh);
  if (told != nullptr && told->correlated) {
    NoiseEstimate noise = even_noise(mesh, told->noise);
    noise.correlated = true;
    return noise;
  }
  NoiseSeen seen = look_for_noise(mesh, rings, position, job);
  NoiseEstimate noise;
  if (!seen.of_stairs.empty()) {
    noise.deviation = std::move(seen.of_stairs);
    noise.evidence = 1;
  } else {
    const NoiseByWhole whole(told != nullptr ? told->testimony : seen.testimony);
    noise.evidence = whole.evidence();
    noise.deviation.resize(mesh.size());
    job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
          noise.deviation[v] = std::sqrt(whole.variance(seen.variance[v], seen.near_by[v], seen.confidence[v]));
    });
  }
  noise.mean = told != nullptr ? told->noise : root_mean_square(noise.deviation, job);
  return noise;
}

}  // namespace vcg_core::detail
