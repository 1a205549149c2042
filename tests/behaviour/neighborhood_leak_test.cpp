// SPDX-License-Identifier: GPL-3.0-or-later
// What section 4 is for: on thin shapes a Euclidean ball takes in the other side, a geodesic neighbourhood does not.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/comparison.h>
#include <support/library_neighborhoods.h>
#include <support/naive_reference.h>
#include <support/noisy_shapes.h>
#include <support/smoothed.h>
#include <support/smoothing_path.h>

namespace {

using namespace test_support;

constexpr double cut_off = 4;  // in |e|: Table 1's

struct Leak {
  std::size_t members = 0;
  std::size_t euclidean_leak = 0;  ///< members of the Euclidean ball that do not belong
  std::size_t geodesic_leak = 0;
};

/// Looks at vertices in the middle of the shape, away from its rim. `belongs` tells whether two vertices are on the
/// same side.
template <class Belongs>
Leak leak(const FlatMesh& mesh, const Belongs& belongs) {
  const double e = average_edge_length(mesh);
  LibraryNeighborhoods neighborhoods(mesh);
  Leak result;
  vcg::Box3d box;
  for (const Point& p : mesh.points) box.Add(p);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point from_center = mesh.points[i] - box.Center();
    const double inside = box.DimX() / 2 - (cut_off + 1) * e;
    if (std::abs(from_center[0]) > inside || std::abs(from_center[1]) > inside) continue;
    for (std::size_t j = 0; j < mesh.points.size(); ++j)
      result.euclidean_leak += (mesh.points[i] - mesh.points[j]).Norm() < cut_off * e && !belongs(i, j);
    for (const std::size_t j : neighborhoods.of(i, cut_off)) {
      ++result.members;
      result.geodesic_leak += !belongs(i, j);
    }
  }
  return result;
}

TEST(NeighborhoodLeak, OnAThinPlate) {
  const FlatMesh plate = noisy_shape("thin_plate", 2000, 0);
  const NaiveReference reference(plate);
  const auto same_side = [&](std::size_t i, std::size_t j) {
    return reference.normal(i)[2] * reference.normal(j)[2] > 0;
  };
  const Leak result = leak(plate, same_side);
  EXPECT_GT(result.members, 1000u);
  EXPECT_EQ(result.geodesic_leak, 0u);
  EXPECT_GT(static_cast<double>(result.euclidean_leak), 0.7 * static_cast<double>(result.members));
}

TEST(NeighborhoodLeak, OnAStackOfThinSheets) {
  const FlatMesh sheets = noisy_shape("thin_sheets", 2000, 0);
  const double e = average_edge_length(sheets);
  const auto same_sheet = [&](std::size_t i, std::size_t j) {
    return std::abs(sheets.points[i][2] - sheets.points[j][2]) < e;
  };
  const Leak result = leak(sheets, same_sheet);
  EXPECT_GT(result.members, 1000u);
  EXPECT_EQ(result.geodesic_leak, 0u);
  EXPECT_GT(static_cast<double>(result.euclidean_leak), 0.7 * static_cast<double>(result.members));
}

class LeakOfTheFilter : public testing::TestWithParam<SmoothingPath> {};

// The same from outside: each sheet of a stack moves as if the others were not there.
TEST_P(LeakOfTheFilter, SheetsDoNotFeelEachOther) {
  const FlatMesh clean = noisy_shape("thin_sheets", 1200, 0);
  const FlatMesh sheets = noisy_shape("thin_sheets", 1200, 0.3);
  const auto spread = [&](FlatMesh mesh, double factor) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.points[v][2] += factor * clean.points[v][2];
    return mesh;
  };
  const FlatMesh together = smoothed(sheets, GetParam().parameters);
  const FlatMesh apart = spread(smoothed(spread(sheets, 100), GetParam().parameters), -100);
  EXPECT_TRUE(same_smoothing(together, apart, GetParam(), average_edge_length(sheets)));
}

INSTANTIATE_TEST_SUITE_P(Paths, LeakOfTheFilter, testing::ValuesIn(smoothing_paths()), name_of_path);

}  // namespace
