// SPDX-License-Identifier: GPL-3.0-or-later
// Creases that the caller names: the guided filter looks at one side of them only.

#include <mesh/creases.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <filters/guided/face_neighborhoods.h>
#include <mesh/read_mesh.h>

#include <job.h>
#include <mesh_tools/random.h>
#include <support/hand_made.h>
#include <support/packed.h>
#include <support/split_mesh.h>
#include <vcg_core/mesh/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::MeshView;
using vcg_core::Method;
using vcg_core::SmoothingReport;

constexpr std::uint32_t side = 41;

/// A roof over the unit square with its ridge along y in the middle, `degrees` between the two faces' normals, with
/// noise in the heights, in multiples of the grid's spacing.
FlatMesh roof(double degrees, double noise) {
  const double slope = std::tan(degrees / 2 / 57.29577951308232);
  mesh_tools::Random random(3);
  return height_field(
      side, [&](double x, double) { return -slope * std::abs(x - 0.5) + noise / (side - 1) * random.normal(); });
}

/// The edges of the ridge.
std::vector<std::uint32_t> ridge() {
  std::vector<std::uint32_t> ends;
  for (std::uint32_t y = 0; y + 1 < side; ++y)
    for (const std::uint32_t end : {y, y + 1}) ends.push_back(end * side + side / 2);
  return ends;
}

struct Smoothed {
  FlatMesh mesh;
  SmoothingReport report;
};

Smoothed smoothed_with(const FlatMesh& mesh, const std::vector<std::uint32_t>& creases, Method method) {
  Packed<double> packed(mesh);
  MeshView view = packed.view();
  view.creases = vcg_core::index_rows(creases.data(), 2 * sizeof(std::uint32_t));
  view.crease_count = creases.size() / 2;
  Smoothed result{mesh, smooth(view, method, vcg_core::method_info(method).defaults)};
  for (std::size_t v = 0; v < mesh.points.size(); ++v) result.mesh.points[v] = packed.point(v);
  return result;
}

/// Mean angle, in degrees, between the normals of the faces at the ridge and those of the roof without noise.
double error_at_ridge(const FlatMesh& found, const FlatMesh& truth, const std::vector<std::uint32_t>& creases) {
  double sum = 0;
  int count = 0;
  const auto normal = [](const FlatMesh& mesh, const Triangle& f) {
    const Point cross = (mesh.points[f[1]] - mesh.points[f[0]]) ^ (mesh.points[f[2]] - mesh.points[f[0]]);
    return cross / cross.Norm();
  };
  for (const Triangle& f : truth.faces) {
    if (std::none_of(f.begin(), f.end(),
                     [&](std::size_t v) { return std::find(creases.begin(), creases.end(), v) != creases.end(); }))
      continue;
    sum += std::acos(std::clamp(normal(found, f) * normal(truth, f), -1.0, 1.0)) * 57.29577951308232;
    ++count;
  }
  return sum / count;
}

TEST(Creases, KeepAnEdgeThatIsTooFlatToBeSeen) {
  const FlatMesh truth = roof(12, 0), noisy = roof(12, 0.1);
  const std::vector<std::uint32_t> creases = ridge();
  const Smoothed with = smoothed_with(noisy, creases, Method::guided);
  const Smoothed without = smoothed_with(noisy, {}, Method::guided);
  EXPECT_EQ(with.report.crease_edges, side - 1);
  EXPECT_EQ(without.report.crease_edges, 0u);
  const double before = error_at_ridge(noisy, truth, creases);
  const double rounded = error_at_ridge(without.mesh, truth, creases);
  const double kept = error_at_ridge(with.mesh, truth, creases);
  EXPECT_LT(rounded, before);
  EXPECT_LT(kept, 0.6 * rounded);
}

TEST(Creases, AreNothingToTheOtherFilters) {
  const FlatMesh noisy = roof(60, 0.1);
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    if (method.method == Method::guided) continue;
    EXPECT_EQ(smoothed_with(noisy, ridge(), method.method).mesh.points,
              smoothed_with(noisy, {}, method.method).mesh.points);
  }
}

TEST(Creases, ThatAreNoEdgesDoNothing) {
  const FlatMesh noisy = roof(60, 0.1);
  const auto last = static_cast<std::uint32_t>(noisy.points.size() - 1);
  const Smoothed found = smoothed_with(noisy, {0, last, 7, 7}, Method::guided);
  EXPECT_EQ(found.report.crease_edges, 0u);
  EXPECT_EQ(found.mesh.points, smoothed_with(noisy, {}, Method::guided).mesh.points);
}

// Named in either direction, more than once, or by any of the copies of its ends.
TEST(Creases, MayBeNamedInAnyWay) {
  const FlatMesh noisy = roof(12, 0.1);
  const std::vector<std::uint32_t> creases = ridge();
  std::vector<std::uint32_t> turned(creases.rbegin(), creases.rend());
  const Smoothed expected = smoothed_with(noisy, creases, Method::guided);
  turned.insert(turned.end(), creases.begin(), creases.end());
  EXPECT_EQ(smoothed_with(noisy, turned, Method::guided).mesh.points, expected.mesh.points);

  const SplitMesh soup = split(noisy, single_faces(noisy), 5);
  std::vector<std::uint32_t> of_copies;
  for (const std::uint32_t v : creases)
    of_copies.push_back(
        static_cast<std::uint32_t>(std::find(soup.original.begin(), soup.original.end(), v) - soup.original.begin()));
  const Smoothed found = smoothed_with(soup.mesh, of_copies, Method::guided);
  EXPECT_EQ(found.report.crease_edges, expected.report.crease_edges);
  for (std::size_t v = 0; v < soup.original.size(); ++v)
    EXPECT_EQ(found.mesh.points[v], expected.mesh.points[soup.original[v]]);
}

TEST(Creases, ThatReferToNoVertexAreRefused) {
  try {
    smoothed_with(potato(1), {0, 1, 2, 4000}, Method::paper);
    ADD_FAILURE() << "no error";
  } catch (const vcg_core::InvalidMesh& error) {
    EXPECT_EQ(std::string(error.what()), "crease 1 refers to a vertex that the mesh does not have");
  }
}

// Around one vertex in the middle of a grid: two creases cut the faces there in two, one alone does not.
TEST(Creases, CutTheFacesAroundAVertexIntoSectors) {
  using namespace vcg_core::detail;
  Packed<double> packed(height_field(3, [](double x, double y) { return x * y; }));
  const vcg_core::Progress no_progress;
  Job job(no_progress, 1);
  const auto sizes = [&](const std::vector<std::uint32_t>& creases) {
    MeshView view = packed.view();
    view.creases = vcg_core::index_rows(creases.data(), 2 * sizeof(std::uint32_t));
    view.crease_count = creases.size() / 2;
    const MeshArrays mesh = read_mesh(view, job);
    const auto middle =
        static_cast<Index>(std::find(mesh.host_vertex.begin(), mesh.host_vertex.end(), 4u) - mesh.host_vertex.begin());
    std::vector<std::size_t> found;
    for (Index s = mesh.topology.star_begin[middle]; s < mesh.topology.star_begin[middle + 1]; ++s) {
      Array<Index> sector;
      add_faces_of_sector(mesh, middle, mesh.topology.star[s], sector);
      found.push_back(sector.size());
    }
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_EQ(sizes({4, 3}), (std::vector<std::size_t>(6, 6)));
  EXPECT_EQ(sizes({4, 3, 4, 5}), (std::vector<std::size_t>(6, 3)));
  EXPECT_EQ(sizes({4, 3, 4, 5, 1, 4, 7, 4}), (std::vector<std::size_t>{1, 1, 2, 2, 2, 2}));
}

}  // namespace
