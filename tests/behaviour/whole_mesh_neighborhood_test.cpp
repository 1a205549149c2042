// SPDX-License-Identifier: GPL-3.0-or-later
// A neighbourhood that is the whole mesh, at 20,000 vertices: slow, but its memory is bounded, the bar moves, and it
// can be cancelled.

#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include <support/allocation_peak.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/progress_log.h>
#include <support/raw_snapshot.h>
#include <vcg_core/smoothing.h>

namespace {

using namespace test_support;
using vcg_core::Arithmetic;
using vcg_core::Method;
using vcg_core::SmoothingParameters;

struct Slow {
  const char* name;
  Method method;
  Arithmetic arithmetic;
  bool bar_moves;  ///< from the beginning of the smoothing; jones first mollifies
};

/// For the names of tests.
void PrintTo(const Slow& slow, std::ostream* out) { *out << slow.name; }

class WholeMeshNeighborhood : public testing::TestWithParam<Slow> {};

TEST_P(WholeMeshNeighborhood, HasBoundedMemoryMovesTheBarAndIsCancelled) {
  DoubleMesh mesh;
  fill(mesh, height_field(142, [](double x, double y) { return 0.1 * std::sin(9 * x) * std::cos(7 * y); }));
  const RawSnapshot<DoubleMesh> untouched(mesh);
  SmoothingParameters parameters;
  parameters.boundary = vcg_core::Boundary::free;
  parameters.rho = 1e6;
  parameters.threads = 2;
  parameters.arithmetic = GetParam().arithmetic;
  // By then neighbourhoods have been gone through, all of the same size.
  int calls = 0;
  ProgressLog log([&](const ProgressLog::Call& call) { return call.stage != "Smoothing" || ++calls < 5; });
  const AllocationPeak peak;
  EXPECT_THROW(vcg_core::smooth(mesh, GetParam().method, parameters, log.callable()), vcg_core::Cancelled);
  EXPECT_TRUE(untouched.unchanged());
  EXPECT_LT(log.calls().back().fraction, 1);
  if (GetParam().bar_moves) {
    EXPECT_GT(log.calls().back().fraction, 0.05) << "the end of the reading";
  }
  EXPECT_LT(peak.bytes(), 2000 * mesh.vert.size()) << "all neighbourhoods at once would be 20,000 times as much";
}

INSTANTIATE_TEST_SUITE_P(Methods, WholeMeshNeighborhood,
                         testing::Values(Slow{"paper", Method::paper, Arithmetic::fast, true},
                                         Slow{"paper_in_reference_arithmetic", Method::paper, Arithmetic::reference,
                                              true},
                                         Slow{"bmd", Method::bmd, Arithmetic::fast, true},
                                         Slow{"jones", Method::jones, Arithmetic::fast, false}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
