// SPDX-License-Identifier: GPL-3.0-or-later
#include "guide_normals.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "faces_around.h"
#include "job.h"
#include "range_weight.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 1024;

/// The median of jumps is that over so many corners.
constexpr std::size_t usual_corners = std::size_t(1) << 18;

/// The faces around one face, taken together.
struct Patch {
  float inconsistency;  ///< equations (6) to (8) of the source: the smaller the better
  float mean[3];        ///< mean normal by area, of unit length
  float spread;         ///< 1 - length of the mean of the unit normals
};

/// Length of the difference of the normals at each edge, by the corner opposite to it, of the face with the lower
/// index.
Array<float> find_jumps(const Array<UnitNormal>& normal, const Array<Index>& across, Job& job) {
  Array<float> jump(across.size());
  job.parallel(normal.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t corner = 3 * chunks.begin(); corner < 3 * chunks.end(); ++corner) {
        const Index g = across[corner];
        if (g == no_face || g <= corner / 3) continue;
        // In double precision: Eigen adds four floats in another order on ARM, which ends in other bits.
        jump[corner] = static_cast<float>((in_double(normal[corner / 3]) - in_double(normal[g])).norm());
      }
  });
  return jump;
}

/// Measures patches.
class PatchMeasure {
 public:
  PatchMeasure(const MeshArrays& mesh, const Array<Index>& across, const Array<float>& jump, const FaceGeometry& faces)
      : around_(mesh, across), across_(across), jump_(jump), faces_(faces) {}

  void forget_all() { around_.forget_all(); }

  Patch measure(Index f) {
    const Array<Index>& patch_faces = around_.find(f);
    Vec3 mean = Vec3::Zero();
    double total = 0;
    for (const Index g : patch_faces) {
      mean += faces_.area[g] * in_double(faces_.normal[g]);
      total += faces_.area[g];
    }
    const double length = mean.norm();
    mean = length > 0 ? Vec3(mean / length) : in_double(faces_.normal[f]);
    Patch patch;
    for (int k = 0; k < 3; ++k) patch.mean[k] = static_cast<float>(mean[k]);
    patch.spread = total > 0 ? static_cast<float>(1 - length / total) : 0;
    patch.inconsistency = static_cast<float>(widest_difference(patch_faces, mean) * edge_concentration(patch_faces));
    return patch;
  }

 private:
  /// The largest distance of a normal from the patch's mean.
  double widest_difference(const Array<Index>& patch_faces, const Vec3& mean) const {
    double widest = 0;
    for (const Index g : patch_faces) widest = std::max(widest, (in_double(faces_.normal[g]) - mean).squaredNorm());
    return std::sqrt(widest);
  }

  /// The largest jump over an edge inside the patch, in the sum of all: near 1 when one edge stands out.
  double edge_concentration(const Array<Index>& patch_faces) const {
    constexpr double no_jumps = 1e-9;
    double sum = no_jumps;
    double largest = 0;
    for (const Index g : patch_faces)
      for (Index k = 0; k < 3; ++k) {
        const Index h = across_[3 * g + k];
        if (h == no_face || h < g || !around_.found(h)) continue;
        const double jump = jump_[3 * g + k];
        sum += jump;
        largest = std::max(largest, jump);
      }
    return largest / sum;
  }

  FacesAround around_;
  const Array<Index>& across_;
  const Array<float>& jump_;
  const FaceGeometry& faces_;
};

Array<Patch> measure_patches(const MeshArrays& mesh, const Array<Index>& across, const Array<float>& jump,
                             const FaceGeometry& faces, Job& job) {
  Array<Patch> patch(mesh.face.size());
  job.parallel(patch.size(), grain, Loop::minor, [&](Chunks& chunks) {
    PatchMeasure measure(mesh, across, jump, faces);
    while (chunks.next()) {
      measure.forget_all();
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) patch[f] = measure.measure(static_cast<Index>(f));
    }
  });
  return patch;
}

struct Guides {
  Array<UnitNormal> normal;
  Array<double> spread;  ///< of the patches that they are taken from
};

/// The mean normals of the most consistent patches that hold each face.
Guides best_guides(const MeshArrays& mesh, const Array<Index>& across, const Array<Patch>& patch, Job& job) {
  const auto better = [&](Index g, Index best) { return patch[g].inconsistency < patch[best].inconsistency; };
  Array<Index> best_at(mesh.size());  // of the faces of each vertex that has some
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (auto v = static_cast<Index>(chunks.begin()); v < chunks.end(); ++v) {
        best_at[v] = no_face;
        visit_faces_of(mesh.topology, v, [&](Index g) {
          if (best_at[v] == no_face || better(g, best_at[v])) best_at[v] = g;
        });
      }
  });
  Guides guides{Array<UnitNormal>(patch.size()), Array<double>(patch.size())};
  job.parallel(patch.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (auto f = static_cast<Index>(chunks.begin()); f < chunks.end(); ++f) {
        Index best = f;
        const auto compare = [&](Index g) {
          if (better(g, best)) best = g;
        };
        visit_faces_around(mesh, across, f, compare, [&](Index v) {
          if (best_at[v] != no_face) compare(best_at[v]);
        });
        const float(&mean)[3] = patch[best].mean;
        guides.normal[f] = UnitNormal(mean[0], mean[1], mean[2], 0);
        guides.spread[f] = patch[best].spread;
      }
  });
  return guides;
}

/// Lengths of the difference of adjoining unit normals that count, of some edges.
Array<double> some_jumps(const MeshArrays& mesh, const Array<float>& jump, const Array<Index>& across,
                         std::size_t most_corners) {
  Array<double> difference;
  const std::size_t stride = std::max<std::size_t>(1, across.size() / most_corners);
  for (std::size_t corner = 0; corner < across.size(); corner += stride) {
    const Index g = across[corner];
    if (g != no_face && g > corner / 3 && mesh.counts_face(corner / 3)) difference.push_back(jump[corner]);
  }
  return difference;
}

Vec3 bilateral_mean(const Array<Index>& around, const FaceGeometry& faces, const RangeWeight<double>& weight) {
  const Vec3 here = in_double(faces.normal[around.front()]);
  Vec3 sum = Vec3::Zero();
  for (const Index g : around) {
    const Vec3 n = in_double(faces.normal[g]);
    sum += faces.area[g] * weight((n - here).squaredNorm()) * n;
  }
  const double length = sum.norm();
  return length > 0 ? Vec3(sum / length) : here;
}

}  // namespace

Array<UnitNormal> guide_normals(const MeshArrays& mesh, const Array<Index>& across, const FaceGeometry& faces,
                                const GuidedSettings& settings, WholeMedians& medians, Job& job) {
  const Array<float> jump = find_jumps(faces.normal, across, job);
  Guides guides = best_guides(mesh, across, measure_patches(mesh, across, jump, faces, job), job);
  if (!settings.guard_thin_parts) return std::move(guides.normal);

  const double trusted = settings.patch_spread * medians.of_faces(guides.spread) + settings.patch_spread_floor;
  const double refused = settings.patch_fade * trusted;
  const double median_jump = medians.of_all(some_jumps(mesh, jump, across, medians.most_values(usual_corners)));
  const RangeWeight<double> weight(std::max(settings.ring_range_floor, settings.ring_range * median_jump));
  job.parallel(guides.normal.size(), grain, Loop::minor, [&](Chunks& chunks) {
    FacesAround around(mesh, across);
    while (chunks.next()) {
      around.forget_all();
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        if (guides.spread[f] <= trusted) continue;
        const double trust = std::max(0.0, (refused - guides.spread[f]) / (refused - trusted));
        const Vec3 mean = bilateral_mean(around.find(static_cast<Index>(f)), faces, weight);
        const Vec3 blend = trust * in_double(guides.normal[f]) + (1 - trust) * mean;
        const double length = blend.norm();
        if (length > 1e-9) guides.normal[f] = in_single(Vec3(blend / length));
      }
    }
  });
  return std::move(guides.normal);
}

}  // namespace vcg_core::detail
