// SPDX-License-Identifier: GPL-3.0-or-later
// The guided filter's guard for thin parts, against the rule of docs/guided.md with its numbers: a patch whose normals
// spread more than three times the mesh's median lends less of its mean normal, and from nine times on nothing.

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <support/arrays_of.h>
#include <support/noisy_shapes.h>

#include "filters/guided/face_geometry.h"
#include "filters/guided/faces_around.h"
#include "filters/guided/guide_normals.h"
#include "filters/guided/guided_settings.h"

namespace {

using namespace vcg_core::detail;

const vcg_core::Progress no_progress;

/// How far a unit vector in single precision may be from what it stands for.
constexpr double single_precision = 1e-7;

double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

class GuideGuard : public testing::TestWithParam<const char*> {
 protected:
  GuideGuard() {
    faces.measure(mesh, mesh.position, job);
    across = faces_across(mesh, job);
    FacesAround found(mesh, across);
    for (Index f = 0; f < mesh.face.size(); ++f) {
      const Array<Index>& list = found.find(f);
      around.emplace_back(list.begin(), list.end());
    }
    median_jump = find_median_jump();
  }

  struct Patch {
    Vec3 mean;
    double inconsistency;
    double spread;
  };

  /// The faces around `center`, from docs/guided.md and Zhang et al. 2015.
  Patch patch(Index center) const {
    const std::set<Index>& members = around[center];
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (const Index g : members) {
      sum += faces.area[g] * in_double(faces.normal[g]);
      area += faces.area[g];
    }
    Patch result{sum.normalized(), 0, 1 - sum.norm() / area};
    double widest = 0, jumps = 1e-9, largest = 0;
    for (const Index g : members) {
      widest = std::max(widest, (in_double(faces.normal[g]) - result.mean).norm());
      for (Index k = 0; k < 3; ++k) {
        const Index h = across[3 * g + k];
        if (h == no_face || h < g || members.count(h) == 0) continue;
        const double jump = (faces.normal[g] - faces.normal[h]).norm();
        jumps += jump;
        largest = std::max(largest, jump);
      }
    }
    result.inconsistency = widest * largest / jumps;
    return result;
  }

  std::vector<Patch> best_patches() const {
    std::vector<Patch> of_face;
    for (Index f = 0; f < mesh.face.size(); ++f) of_face.push_back(patch(f));
    std::vector<Patch> best;
    for (Index f = 0; f < mesh.face.size(); ++f)
      best.push_back(of_face[*std::min_element(around[f].begin(), around[f].end(), [&](Index a, Index b) {
        return of_face[a].inconsistency < of_face[b].inconsistency;
      })]);
    return best;
  }

  double find_median_jump() const {
    std::vector<double> jumps;
    for (Index corner = 0; corner < across.size(); ++corner)
      if (across[corner] != no_face && across[corner] > corner / 3)
        jumps.push_back((faces.normal[corner / 3] - faces.normal[across[corner]]).norm());
    return middle_of(jumps);
  }

  /// What an untrusted patch is replaced by: a bilateral mean over the faces around, with a range sigma of 1.8 times
  /// the median jump, and at least 0.3.
  Vec3 bilateral(Index f) const {
    const double sigma = std::max(0.3, 1.8 * median_jump);
    Vec3 sum = Vec3::Zero();
    for (const Index g : around[f])
      sum += faces.area[g] * std::exp(-(faces.normal[g] - faces.normal[f]).squaredNorm() / (2 * sigma * sigma)) *
             in_double(faces.normal[g]);
    return sum.normalized();
  }

  Job job{no_progress, 2};
  MeshArrays mesh = test_support::arrays_of(test_support::noisy_shape(GetParam(), 1200, 0.1), job);
  WholeMedians medians{mesh};
  FaceGeometry faces;
  Array<Index> across;
  std::vector<std::set<Index>> around;
  double median_jump = 0;  ///< length of the difference of adjoining normals
};

TEST_P(GuideGuard, FadesPatchesThatSpreadMoreThanThreeTimesTheMedian) {
  const Array<UnitNormal> guide = guide_normals(mesh, across, faces, GuidedSettings{}, medians, job);
  const std::vector<Patch> best = best_patches();
  std::vector<double> spreads;
  for (const Patch& p : best) spreads.push_back(p.spread);
  const double trusted = 3 * middle_of(spreads) + 0.005;
  const double refused = 3 * trusted;
  int trusted_faces = 0, fading_faces = 0, faces_below_twice = 0, refused_faces = 0;
  for (Index f = 0; f < mesh.face.size(); ++f) {
    const double trust = std::clamp((refused - best[f].spread) / (refused - trusted), 0.0, 1.0);
    const Vec3 expected = (trust * best[f].mean + (1 - trust) * bilateral(f)).normalized();
    // The filter's exponential is exact to 0.009; a trusted mean does not have one.
    EXPECT_LT((in_double(guide[f]) - expected).norm(), trust == 1 ? single_precision : 0.02) << f;
    trusted_faces += trust == 1;
    fading_faces += trust > 0 && trust < 1;
    faces_below_twice += trust < 0.9 && best[f].spread < 2 * trusted;
    refused_faces += trust == 0;
  }
  EXPECT_GT(trusted_faces, 200);
  EXPECT_GT(faces_below_twice, 5) << "which a guard from six times the median on would trust";
  EXPECT_GT(fading_faces, 10);
  EXPECT_GT(refused_faces, 20);
}

TEST_P(GuideGuard, OffTrustsEveryBestPatch) {
  GuidedSettings settings;
  settings.guard_thin_parts = false;
  const Array<UnitNormal> guide = guide_normals(mesh, across, faces, settings, medians, job);
  const std::vector<Patch> best = best_patches();
  for (Index f = 0; f < mesh.face.size(); ++f)
    EXPECT_LT((in_double(guide[f]) - best[f].mean).norm(), single_precision) << f;
}

INSTANTIATE_TEST_SUITE_P(Shapes, GuideGuard, testing::Values("thin_plate", "cad_part"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
