// SPDX-License-Identifier: GPL-3.0-or-later
#include "guide_normals.h"

#include <algorithm>
#include <cmath>

#include "job.h"
#include "range_weight.h"
#include "sparse_index_map.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 1024;

/// The median of jumps is that over so many corners.
constexpr std::size_t usual_corners = std::size_t(1) << 18;

/// The faces around one face, taken together.
struct Patch {
  double inconsistency;  ///< equations (6) to (8) of the source: the smaller the better
  float mean[3];         ///< mean normal by area, of unit length
  float spread;          ///< 1 - length of the mean of the unit normals
};

/// Measures patches; remembers which faces belong to the current one.
class PatchMeasure {
 public:
  PatchMeasure(const FaceLists& around, const Array<Index>& across, const Array<double>& jump,
               const Array<double>& area, const Array<Vec3>& normal)
      : around_(around), across_(across), jump_(jump), area_(area), normal_(normal), member_of_(area.size()) {}

  /// Keeps the memory small: to be called now and then, between two patches.
  void forget_all() { member_of_.clear(); }

  Patch measure(Index f) {
    Vec3 mean = Vec3::Zero();
    double total = 0;
    for (const Index* g = around_.first(f); g != around_.last(f); ++g) {
      mean += area_[*g] * normal_[*g];
      total += area_[*g];
    }
    const double length = mean.norm();
    mean = length > 0 ? Vec3(mean / length) : normal_[f];
    Patch patch;
    for (int k = 0; k < 3; ++k) patch.mean[k] = static_cast<float>(mean[k]);
    patch.spread = total > 0 ? static_cast<float>(1 - length / total) : 0;
    patch.inconsistency = widest_difference(f, mean) * edge_concentration(f);
    return patch;
  }

 private:
  /// The largest distance of a normal from the patch's mean.
  double widest_difference(Index f, const Vec3& mean) {
    double widest = 0;
    for (const Index* g = around_.first(f); g != around_.last(f); ++g) {
      member_of_.set(*g, f);
      widest = std::max(widest, (normal_[*g] - mean).squaredNorm());
    }
    return std::sqrt(widest);
  }

  /// The largest jump over an edge inside the patch, in the sum of all: near 1 when one edge stands out.
  double edge_concentration(Index f) const {
    constexpr double no_jumps = 1e-9;
    double sum = no_jumps;
    double largest = 0;
    for (const Index* g = around_.first(f); g != around_.last(f); ++g)
      for (Index k = 0; k < 3; ++k) {
        const Index h = across_[3 * *g + k];
        if (h == no_face || h < *g || member_of_[h] != f) continue;
        sum += jump_[3 * *g + k];
        largest = std::max(largest, jump_[3 * *g + k]);
      }
    return largest / sum;
  }

  const FaceLists& around_;
  const Array<Index>& across_;
  const Array<double>& jump_;
  const Array<double>& area_;
  const Array<Vec3>& normal_;
  SparseIndexMap member_of_;  ///< by face: the patch that it was last found in
};

/// Length of the difference of the normals at each edge, by the corner opposite to it, of the face with the lower
/// index.
Array<double> find_jumps(const Array<Vec3>& normal, const Array<Index>& across, Job& job) {
  Array<double> jump(across.size());
  job.parallel(normal.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t corner = 3 * chunks.begin(); corner < 3 * chunks.end(); ++corner) {
        const Index g = across[corner];
        if (g != no_face && g > corner / 3) jump[corner] = (normal[corner / 3] - normal[g]).norm();
      }
  });
  return jump;
}

/// Lengths of the difference of adjoining unit normals that count, of some edges.
Array<double> some_jumps(const MeshArrays& mesh, const Array<double>& jump, const Array<Index>& across,
                         std::size_t most_corners) {
  Array<double> difference;
  const std::size_t stride = std::max<std::size_t>(1, across.size() / most_corners);
  for (std::size_t corner = 0; corner < across.size(); corner += stride) {
    const Index g = across[corner];
    if (g != no_face && g > corner / 3 && mesh.counts_face(corner / 3)) difference.push_back(jump[corner]);
  }
  return difference;
}

Vec3 bilateral_mean(const FaceLists& around, Index f, const Array<double>& area, const Array<Vec3>& normal,
                    const RangeWeight<double>& weight) {
  Vec3 sum = Vec3::Zero();
  for (const Index* g = around.first(f); g != around.last(f); ++g)
    sum += area[*g] * weight((normal[*g] - normal[f]).squaredNorm()) * normal[*g];
  const double length = sum.norm();
  return length > 0 ? Vec3(sum / length) : normal[f];
}

}  // namespace

Array<UnitNormal> guide_normals(const MeshArrays& mesh, const FaceLists& around, const Array<Index>& across,
                                const FaceGeometry& faces, const Array<Vec3>& normal, const GuidedSettings& settings,
                                WholeMedians& medians, Job& job) {
  const std::size_t count = normal.size();
  const Array<double> jump = find_jumps(normal, across, job);
  Array<Patch> patch(count);
  job.parallel(count, grain, Loop::minor, [&](Chunks& chunks) {
    PatchMeasure measure(around, across, jump, faces.area, normal);
    while (chunks.next()) {
      measure.forget_all();
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) patch[f] = measure.measure(static_cast<Index>(f));
    }
  });

  Array<UnitNormal> guide(count);
  Array<double> spread(count);
  job.parallel(count, grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const Index* best = around.first(f);
        for (const Index* g = best; g != around.last(f); ++g)
          if (patch[*g].inconsistency < patch[*best].inconsistency) best = g;
        const float(&mean)[3] = patch[*best].mean;
        guide[f] = UnitNormal(mean[0], mean[1], mean[2], 0);
        spread[f] = patch[*best].spread;
      }
  });
  if (!settings.guard_thin_parts) return guide;

  const double trusted = settings.patch_spread * medians.of_faces(spread) + settings.patch_spread_floor;
  const double refused = settings.patch_fade * trusted;
  const double median_jump = medians.of_all(some_jumps(mesh, jump, across, medians.most_values(usual_corners)));
  const RangeWeight<double> weight(std::max(settings.ring_range_floor, settings.ring_range * median_jump));
  job.parallel(count, grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        if (spread[f] <= trusted) continue;
        const double trust = std::max(0.0, (refused - spread[f]) / (refused - trusted));
        const Vec3 mean = bilateral_mean(around, static_cast<Index>(f), faces.area, normal, weight);
        const Vec3 blend = trust * guide[f].head<3>().cast<double>() + (1 - trust) * mean;
        const double length = blend.norm();
        if (length > 1e-9) guide[f] = in_single(Vec3(blend / length));
      }
  });
  return guide;
}

}  // namespace vcg_core::detail
