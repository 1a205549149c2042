// The vector kernels, each that this processor runs, against the scalar march and the scalar filter.

#include <lanes/lane_kernels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <geodesic_march.h>
#include <lanes/lane_filter.h>
#include <lanes/patch_builder.h>
#include <paper_filter.h>
#include <triangle_frames.h>
#include <vcg_core/detail/read_mesh.h>
#include <vertex_normals.h>

#include <support/hand_made.h>
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
    arrays_ = read_mesh(mesh_, job_);
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
    return LanePass(kernel).run({arrays_, arrays_.position, normal_, movable_, parameters, job_});
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

/// Largest difference, in |e|, of the kernel's distances from the scalar march's, over vertices below `cutoff` in both.
/// Also sees to it that no vertex well inside is missing.
double largest_distance_error(const FlatMesh& shape, const LaneKernel& kernel, double cutoff) {
  Prepared mesh(shape);
  const MeshArrays& arrays = mesh.arrays();
  const auto ring = make_rings(arrays, mesh.job());
  const SourceGroups groups = group_sources(arrays, kernel.lanes, mesh.job());
  const LaneMesh lanes{arrays, ring, groups, arrays.position, mesh.normal()};
  PatchBuilder builder(lanes, kernel);
  const auto frames = triangle_frames(arrays, arrays.position, mesh.unit(), mesh.job());
  GeodesicMarch<double> march(arrays, frames, 1e-9);
  LaneParameters parameters{};
  parameters.cutoff = static_cast<float>(cutoff);
  parameters.limit = static_cast<float>(cutoff + march_margin);
  parameters.tolerance = 4e-6f;
  const LanePoll no_poll = [](void*) {};
  double largest = 0;
  const Array<Index> patch_begin = patch_groups(groups, arrays);
  for (std::size_t p = 0, g = 0; g < groups.size(); ++g) {
    if (g == patch_begin[p + 1]) ++p;
    const Patch& patch = builder.build(patch_begin[p], patch_begin[p + 1], cutoff + march_margin);
    kernel.shape(patch, no_poll, nullptr);
    const PatchGroup& group = builder.group(g);
    kernel.march(patch, group, parameters, no_poll, nullptr);
    for (std::uint32_t lane = 0; lane < group.sources; ++lane) {
      EXPECT_EQ(builder.vertex(group.source_row[lane]), groups.member[groups.begin[g] + lane]);
      march.run(groups.member[groups.begin[g] + lane], cutoff + march_margin, [](std::size_t) {});
      std::vector<bool> found(arrays.size(), false);
      for (std::uint32_t rank = 0; rank < group.rows; ++rank) {
        const Index v = builder.vertex(group.row_at[rank]);
        found[v] = true;
        const double expected = march.distance(v);
        const double distance = patch.distance[group.row_at[rank] * kernel.lanes + lane];
        if (expected < cutoff || distance < cutoff) largest = std::max(largest, std::abs(distance - expected));
      }
      for (const Index v : march.reached())
        if (march.distance(v) < cutoff) {
          EXPECT_TRUE(found[v]);
        }
    }
  }
  return largest;
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
  EXPECT_LE(largest_distance_error(crown, *GetParam(), 6), 2e-5);
  EXPECT_LE(largest_distance_error(crown, *GetParam(), 12), 2e-5);
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
      std::vector<bool> near(arrays.size(), false);
      for (std::uint32_t rank = 0; rank < group.rows; ++rank) near[builder.vertex(group.row_at[rank])] = true;
      for (Index v = 0; v < arrays.size(); ++v) {
        double nearest = 1e9;
        for (Index s = groups.begin[g]; s < groups.begin[g + 1]; ++s)
          nearest = std::min(nearest, (arrays.position[v] - arrays.position[groups.member[s]]).norm() / mesh.unit());
        if (std::abs(nearest - reach) < 1e-5) continue;  // by rounding
        EXPECT_EQ(near[v], in_patch[v] && nearest < reach) << v;
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
  LaneParameters parameters{};
  parameters.cutoff = parameters.limit = 1e6f;
  parameters.tolerance = 4e-6f;
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
