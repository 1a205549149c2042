// A neighbourhood that is the whole mesh, at 20,000 vertices: slow, but its memory is bounded, the bar moves, and it
// can be cancelled.

#include <cmath>

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
};

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
  // At 7 % the first of the neighbourhoods are done, all of the same size.
  ProgressLog log([](const ProgressLog::Call& call) { return call.fraction < 0.07; });
  const AllocationPeak peak;
  EXPECT_THROW(vcg_core::smooth(mesh, GetParam().method, parameters, log.callable()), vcg_core::Cancelled);
  EXPECT_TRUE(untouched.unchanged());
  EXPECT_GT(log.calls().size(), 2u);
  EXPECT_LT(peak.bytes(), 2000 * mesh.vert.size()) << "all neighbourhoods at once would be 20,000 times as much";
}

INSTANTIATE_TEST_SUITE_P(Methods, WholeMeshNeighborhood,
                         testing::Values(Slow{"paper", Method::paper, Arithmetic::fast},
                                         Slow{"paper_in_reference_arithmetic", Method::paper, Arithmetic::reference},
                                         Slow{"bmd", Method::bmd, Arithmetic::fast},
                                         Slow{"jones", Method::jones, Arithmetic::fast}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
