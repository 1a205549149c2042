// SPDX-License-Identifier: GPL-3.0-or-later
// The vector kernels, each that this processor runs, against the scalar march and the scalar filter.

#include <filters/paper/lanes/lane_kernels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <filters/paper/lanes/lane_filter.h>
#include <filters/paper/lanes/lane_parameters.h>
#include <filters/paper/lanes/patch_builder.h>
#include <filters/paper/paper_filter.h>
#include <geodesic_march.h>
#include <job.h>
#include <mesh/read_mesh.h>
#include <triangle_frames.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vertex_normals.h>

#include <support/hand_made.h>
#include <support/high_valence.h>
#include <support/mesh_types.h>
#include <support/noisy_shapes.h>

namespace {

using namespace test_support;
using namespace vcg_core::detail;
using vcg_core::SmoothingParameters;

/// A mesh as a filter's pass gets it.
class Prepared {
 public:
  explicit Prepared(const FlatMesh& shape, int threads = 2) : job_(no_progress_, threads) {
    fill(mesh_, shape);
    arrays_ = read_mesh(vcg_core::view_of(mesh_), job_);
    normal_ = vertex_normals(arrays_, arrays_.position, job_);
    for (std::size_t v = 0; v < arrays_.size(); ++v) movable_.push_back(!normal_[v].isZero(0));
  }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  const MeshArrays& arrays() const { return arrays_; }
  const Array<Vec3>& normal() const { return normal_; }
  const Array<std::uint8_t>& movable() const { return movable_; }
  Job& job() { return job_; }
  double unit() const { return arrays_.topology.average_edge_length; }

  Array<Vec3> run(const LaneKernel& kernel, const SmoothingParameters& parameters) {
    return run_with_figures(kernel, parameters).position;
  }
  PassOutput run_with_figures(const LaneKernel& kernel, const SmoothingParameters& parameters) {
    return LanePass(parameters, kernel).run({arrays_, arrays_.position, normal_, movable_, job_});
  }

  /// Lets only `count` vertices move, evenly drawn from the mesh's order.
  void move_only(std::size_t count) {
    movable_.assign(arrays_.size(), 0);
    for (std::size_t k = 0; k < count; ++k) movable_[k * arrays_.size() / count] = 1;
  }

 private:
  const vcg_core::Progress no_progress_;
  Job job_;
  DoubleMesh mesh_;
  MeshArrays arrays_;
  Array<Vec3> normal_;
  Array<std::uint8_t> movable_;
};

/// Number of vertices that two results place farther apart than `tolerance`.
std::size_t differing(const Array<Vec3>& a, const Array<Vec3>& b, double tolerance) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < a.size(); ++v) count += !((a[v] - b[v]).norm() <= tolerance);
  return count;
}

class LaneKernels : public testing::TestWithParam<const LaneKernel*> {};

TEST_P(LaneKernels, AgreeWithTheScalarFilter) {
  for (const std::string& name : shape_names()) {
    Prepared mesh(noisy_shape(name, 1000));
    const SmoothingParameters parameters;
    const Array<Vec3> expected =
        paper_pass(mesh.arrays(), mesh.arrays().position, mesh.normal(), mesh.movable(), parameters, mesh.job());
    const Array<Vec3> result = mesh.run(*GetParam(), parameters);
    // A distance may fall on the other side of the cut-off by the rounding of single precision.
    EXPECT_LE(differing(result, expected, 2e-6 * mesh.unit()), mesh.arrays().size() / 500) << name;
  }
}

TEST_P(LaneKernels, GiveTheSameBitsForAnyNumberOfThreads) {
  const FlatMesh shape = noisy_shape("stepped_block", 2000);
  const Array<Vec3> expected = Prepared(shape, 1).run(*GetParam(), {});
  for (const int threads : {2, 3, 8}) EXPECT_EQ(Prepared(shape, threads).run(*GetParam(), {}), expected);
}

/// What came out of marching from some groups of sources.
struct Marched {
  double error = 0;          ///< largest difference of a distance from the scalar march's, below the cut-off in one
  double largest = 0;        ///< largest distance below the cut-off
  std::uint64_t looks = 0;   ///< of the kernel
  std::size_t pairs = 0;     ///< (source, vertex below the cut-off)
  std::size_t loosened = 0;  ///< groups whose tolerance was raised
};

/// Marches from every n-th patch's groups, and compares with the scalar march from every k-th source of these; 0: none.
/// Also sees to it that no vertex well inside is missing.
Marched march(const FlatMesh& shape, const LaneKernel& kernel, const LaneParameters& parameters,
              std::size_t patch_stride = 1, std::uint32_t source_stride = 1) {
  Prepared mesh(shape);
  const MeshArrays& arrays = mesh.arrays();
  const auto ring = make_rings(arrays, mesh.job());
  const SourceGroups groups = group_sources(arrays, kernel.lanes, mesh.job());
  const LaneMesh lanes{arrays, ring, groups, arrays.position, mesh.normal()};
  PatchBuilder builder(lanes, kernel);
  const auto frames = triangle_frames(arrays, arrays.position, mesh.unit(), mesh.job());
  GeodesicMarch<double> scalar(arrays, frames, 1e-9);
  const double cutoff = parameters.cutoff;
  const double limit = cutoff + march_margin;
  const LanePoll no_poll = [](void*) {};
  Marched result;
  const Array<Index> patch_begin = patch_groups(groups, arrays);
  for (std::size_t p = 0; p + 1 < patch_begin.size(); p += patch_stride) {
    const Patch& patch = builder.build(patch_begin[p], patch_begin[p + 1], limit);
    kernel.shape(patch, no_poll, nullptr);
    for (Index g = patch_begin[p]; g < patch_begin[p + 1]; ++g) {
      const PatchGroup& group = builder.group(g);
      const MarchWork work = kernel.march(patch, group, parameters, no_poll, nullptr);
      result.looks += work.looks;
      result.loosened += work.loosened ? 1 : 0;
      const auto distance_at = [&](std::uint32_t rank, std::uint32_t lane) {
        return static_cast<double>(patch.distance[std::size_t(group.row_at[rank]) * kernel.lanes + lane]);
      };
      for (std::uint32_t rank = 0; rank < group.rows; ++rank)
        for (std::uint32_t lane = 0; lane < group.sources; ++lane) result.pairs += distance_at(rank, lane) < cutoff;
      for (std::uint32_t lane = 0; source_stride != 0 && lane < group.sources; lane += source_stride) {
        EXPECT_EQ(builder.vertex(group.source_row[lane]), groups.member[groups.begin[g] + lane]);
        scalar.run(groups.member[groups.begin[g] + lane], limit, [](std::size_t) {});
        std::vector<bool> found(arrays.size(), false);
        for (std::uint32_t rank = 0; rank < group.rows; ++rank) {
          const Index v = builder.vertex(group.row_at[rank]);
          found[v] = true;
          const double expected = scalar.distance(v);
          const double distance = distance_at(rank, lane);
          if (!(expected < cutoff || distance < cutoff)) continue;
          result.error = std::max(result.error, std::abs(distance - expected));
          result.largest = std::max(result.largest, distance);
        }
        for (const Index v : scalar.reached())
          if (scalar.distance(v) < cutoff) {
            EXPECT_TRUE(found[v]);
          }
      }
    }
  }
  return result;
}

/// The filter's own constants, the tolerance among them, with another cut-off.
LaneParameters with_cutoff(double cutoff) {
  SmoothingParameters parameters;
  parameters.sigma_c = cutoff / parameters.rho;
  return lane_parameters(parameters);
}

double largest_distance_error(const FlatMesh& shape, const LaneKernel& kernel, double cutoff) {
  return march(shape, kernel, with_cutoff(cutoff)).error;
}

TEST_P(LaneKernels, MarchAsTheScalarOne) {
  EXPECT_LE(largest_distance_error(potato(2), *GetParam(), 4), 1e-5);
  EXPECT_LE(largest_distance_error(noisy_shape("thin_plate", 150), *GetParam(), 3), 1e-5);
}

// A face without area that hangs on its middle vertex only: the way to both its ends leads over that vertex.
TEST_P(LaneKernels, MarchOverAFaceWithoutArea) {
  const FlatMesh hanging{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0.25}, {2, 3, 0}, {1, 3, 0}, {3, 3, 0}},
                         {{0, 1, 2}, {1, 3, 2}, {4, 5, 3}}};
  EXPECT_LE(largest_distance_error(hanging, *GetParam(), 4), 1e-5);
}

// More faces at a vertex than the march has bits for: a crown of 100 around one, with heights that go up and down.
TEST_P(LaneKernels, MarchAroundAVertexOfManyFaces) {
  constexpr std::uint32_t count = 100;
  FlatMesh crown{{{0, 0, 0}}, {}};
  for (const double radius : {1.0, 1.5, 2.0})
    for (std::uint32_t k = 0; k < count; ++k) {
      const double phi = 2 * 3.14159265358979 * k / count;
      crown.points.emplace_back(radius * std::cos(phi), radius * std::sin(phi), 0.2 * std::sin(7 * phi + radius));
    }
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t a = 1 + k;
    const std::uint32_t b = 1 + (k + 1) % count;
    crown.faces.push_back({0, a, b});
    for (const std::uint32_t ring : {0u, count}) {
      crown.faces.push_back({a + ring, a + ring + count, b + ring});
      crown.faces.push_back({b + ring, a + ring + count, b + ring + count});
    }
  }
  EXPECT_LE(largest_distance_error(crown, *GetParam(), 6), 3e-5);
  EXPECT_LE(largest_distance_error(crown, *GetParam(), 12), 3e-5);
}

// Closed surfaces across which it is farther than 150 |e|: there a float's last place is more than the tolerance, and
// lanes reach the rows on the far side from all around. The march must end by itself, at the scalar march's distances.
TEST_P(LaneKernels, ComeToAnEndAcrossAWholeClosedMesh) {
  for (const char* name : {"sphere", "cube"}) {
    const FlatMesh shape = noisy_shape(name, 45000);
    const Marched result = march(shape, *GetParam(), with_cutoff(1000), 1000000, 64);
    EXPECT_GT(result.largest, 150) << name;
    // Single precision's last place is 1.5e-5 from 128 |e| on; some hundred steps lead there.
    EXPECT_LE(result.error, 3e-4) << name;
    EXPECT_EQ(result.loosened, 0u) << name;
  }
}

TEST_P(LaneKernels, AgreeWithTheScalarFilterWhereANeighborhoodIsAWholeClosedMesh) {
  Prepared mesh(noisy_shape("sphere", 45000));
  mesh.move_only(3);
  SmoothingParameters parameters;
  parameters.sigma_c = 80;
  parameters.rho = 10;
  const Array<Vec3> expected =
      paper_pass(mesh.arrays(), mesh.arrays().position, mesh.normal(), mesh.movable(), parameters, mesh.job());
  EXPECT_EQ(differing(expected, mesh.arrays().position, 1e-3 * mesh.unit()), 3u) << "nothing to compare";
  const PassOutput result = mesh.run_with_figures(*GetParam(), parameters);
  // Sums of 45,000 weights in single precision.
  EXPECT_EQ(differing(result.position, expected, 1e-4 * mesh.unit()), 0u);
  EXPECT_EQ(result.approximate_neighbourhoods, 0u);
}

/// Looks of the kernel for a pair, counted in lanes.
double looks_per_pair(const Marched& marched, const LaneKernel& kernel) {
  return static_cast<double>(marched.looks) * kernel.lanes / static_cast<double>(marched.pairs);
}

// Where neighbourhoods are marched through by a queue, looks are more, and most are bounds, which cost less.
TEST_P(LaneKernels, LookAsOftenForEachPairWhateverTheSizeOfTheNeighborhood) {
  for (const char* name : {"torus", "cad_part"}) {
    const FlatMesh shape = noisy_shape(name, 5000);
    const double small = looks_per_pair(march(shape, *GetParam(), with_cutoff(4), 4, 0), *GetParam());
    for (const double cutoff : {12, 48, 200})
      EXPECT_LE(looks_per_pair(march(shape, *GetParam(), with_cutoff(cutoff), 16, 0), *GetParam()), 2.5 * small)
          << name << " " << cutoff;
  }
}

TEST_P(LaneKernels, LookTenTimesAsOftenAtMostAroundVerticesOfManyFaces) {
  const double scan =
      looks_per_pair(march(noisy_shape("cad_part", 4000), *GetParam(), with_cutoff(4), 2, 0), *GetParam());
  for (const std::size_t n : {40, 300, 1500})
    for (const auto& [name, mesh] : high_valence_meshes(n)) {
      const Marched result = march(mesh, *GetParam(), with_cutoff(4), n / 100 + 1, 0);
      EXPECT_LE(looks_per_pair(result, *GetParam()), 10 * scan) << name << " " << n;
    }
}

// Each of thousands of steps along edges of hundredths of |e| may lose a unit in the last place.
TEST_P(LaneKernels, MarchAsTheScalarOneAroundVerticesOfManyFaces) {
  for (const std::size_t n : {33, 300})
    for (const auto& [name, mesh] : high_valence_meshes(n)) {
      // Its longest edges lead beyond the margin, and there the two marches follow different ones.
      if (name == "prism_clipped_in_turn") continue;
      const Marched result = march(mesh, *GetParam(), with_cutoff(20), n / 50 + 1, 7);
      EXPECT_LE(result.error, 5e-4) << name << " " << n;
      EXPECT_GT(result.pairs, 0u) << name << " " << n;
    }
}

// However few looks are allowed, the march ends, at distances of paths that there are: none is too short, all sources
// are there, and it says that it was cut short.
TEST_P(LaneKernels, EndWithinTheLooksTheyAreAllowed) {
  LaneParameters parameters = with_cutoff(20);
  for (const auto& [name, mesh] : high_valence_meshes(300)) {
    const Marched exact = march(mesh, *GetParam(), parameters, 2, 0);
    LaneParameters hasty = parameters;
    hasty.looks_per_corner = 0;
    const Marched result = march(mesh, *GetParam(), hasty, 2, 0);
    EXPECT_GT(result.loosened, 0u) << name;
    EXPECT_LT(result.looks, exact.looks) << name;
    EXPECT_LE(result.pairs, exact.pairs) << name;
  }
}

// Not one row of the patch more, as each costs time, and none less, as the filter would be another.
TEST_P(LaneKernels, LookAtTheRowsWithinReachOfASource) {
  constexpr double reach = 2.5;
  Prepared mesh(noisy_shape("stepped_block", 1500));
  const MeshArrays& arrays = mesh.arrays();
  const auto ring = make_rings(arrays, mesh.job());
  const SourceGroups groups = group_sources(arrays, GetParam()->lanes, mesh.job());
  const LaneMesh lanes{arrays, ring, groups, arrays.position, mesh.normal()};
  PatchBuilder builder(lanes, *GetParam());
  const Array<Index> patch_begin = patch_groups(groups, arrays);
  for (std::size_t p = 0; p + 1 < patch_begin.size(); ++p) {
    const Patch& patch = builder.build(patch_begin[p], patch_begin[p + 1], reach);
    std::vector<bool> in_patch(arrays.size(), false);
    for (std::uint32_t row = 0; row < patch.rows; ++row) in_patch[builder.vertex(row)] = true;
    for (Index g = patch_begin[p]; g < patch_begin[p + 1]; ++g) {
      const PatchGroup& group = builder.group(g);
      std::vector<bool> is_near(arrays.size(), false);
      for (std::uint32_t rank = 0; rank < group.rows; ++rank) is_near[builder.vertex(group.row_at[rank])] = true;
      for (Index v = 0; v < arrays.size(); ++v) {
        double nearest = 1e9;
        for (Index s = groups.begin[g]; s < groups.begin[g + 1]; ++s)
          nearest = std::min(nearest, (arrays.position[v] - arrays.position[groups.member[s]]).norm() / mesh.unit());
        if (std::abs(nearest - reach) < 1e-5) continue;  // by rounding
        EXPECT_EQ(is_near[v], in_patch[v] && nearest < reach) << v;
      }
    }
  }
}

// Cancelling in time, without a clock: a patch of 20,000 rows is polled from at every 4,096 of them or more often.
TEST_P(LaneKernels, PollInsideALargePatch) {
  Prepared mesh(grid(142));
  const auto ring = make_rings(mesh.arrays(), mesh.job());
  const SourceGroups groups = group_sources(mesh.arrays(), GetParam()->lanes, mesh.job());
  const LaneMesh lanes{mesh.arrays(), ring, groups, mesh.arrays().position, mesh.normal()};
  PatchBuilder builder(lanes, *GetParam());
  const Patch& patch = builder.build(0, 1, 1e6);
  ASSERT_EQ(patch.rows, 142u * 142u);
  const LaneParameters parameters = with_cutoff(1e6);
  GetParam()->shape(
      patch, [](void*) {}, nullptr);
  std::size_t polls = 0;
  GetParam()->march(
      patch, builder.group(0), parameters, [](void* count) { ++*static_cast<std::size_t*>(count); }, &polls);
  EXPECT_GE(polls, patch.rows / 4096);
}

// The scalar march, which also finds the distances from one vertex, polls as often.
TEST(GeodesicMarch, PollsInsideALargeNeighborhood) {
  Prepared mesh(grid(142));
  const auto frames = triangle_frames(mesh.arrays(), mesh.arrays().position, mesh.unit(), mesh.job());
  GeodesicMarch<double> march(mesh.arrays(), frames, 1e-9);
  std::vector<std::size_t> settled;
  march.run(0, 1e6, [&](std::size_t count) { settled.push_back(count); });
  ASSERT_EQ(march.reached().size(), 142u * 142u);
  ASSERT_GE(settled.size(), 142u * 142u / 4096);
  for (std::size_t k = 1; k < settled.size(); ++k) EXPECT_EQ(settled[k] - settled[k - 1], 4096u);
}

INSTANTIATE_TEST_SUITE_P(Supported, LaneKernels, testing::ValuesIn(supported_lane_kernels()), [](const auto& kernel) {
  std::string name = kernel.param->name;
  name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }),
             name.end());
  return name;
});

}  // namespace
