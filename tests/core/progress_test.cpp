// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and cancelling, clause by clause.

#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <job.h>
#include <support/hand_made.h>
#include <support/mesh_types.h>
#include <support/progress_log.h>
#include <support/raw_snapshot.h>
#include <vcg_core/geodesic_distance.h>
#include <vcg_core/smoothing.h>

#include <mesh/read_mesh.h>
#include <smooth_arrays.h>

namespace {

using namespace test_support;
using std::chrono::duration;
using vcg_core::SmoothingParameters;

double seconds(ProgressLog::Clock::duration d) { return duration<double>(d).count(); }

class ProgressOfSmoothing : public testing::TestWithParam<int> {
 protected:
  ProgressOfSmoothing() {
    fill(mesh_, potato(4));
    parameters_.sigma_c = 3;
    parameters_.threads = GetParam();
  }

  /// Makes it long enough for many calls on any machine: 10,242 neighbourhoods of as many vertices. Only of use where
  /// it is cancelled.
  void make_long() {
    mesh_.Clear();
    fill(mesh_, potato(5));
    parameters_.rho = 1e6;
  }

  DoubleMesh mesh_;
  SmoothingParameters parameters_;
};

TEST_P(ProgressOfSmoothing, BeginsWithZeroAndEndsWithOne) {
  ProgressLog log;
  vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, log.callable());
  ASSERT_GE(log.calls().size(), 2u);
  EXPECT_EQ(log.calls().front().fraction, 0);
  EXPECT_EQ(log.calls().back().fraction, 1);
}

TEST_P(ProgressOfSmoothing, CancelledAtTheFirstCall) {
  const RawSnapshot<DoubleMesh> before(mesh_);
  ProgressLog log([](const auto&) { return false; });
  EXPECT_THROW(vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, log.callable()), vcg_core::Cancelled);
  EXPECT_EQ(log.calls().size(), 1u);
  EXPECT_TRUE(before.unchanged());
}

TEST_P(ProgressOfSmoothing, CancelledInTheMiddle) {
  make_long();
  const RawSnapshot<DoubleMesh> before(mesh_);
  ProgressLog log([](const auto& call) { return call.stage == "Reading the mesh" || call.fraction < 0.055; });
  EXPECT_THROW(vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, log.callable()), vcg_core::Cancelled);
  EXPECT_GE(log.calls().back().fraction, 0.055);
  EXPECT_LT(log.calls().back().fraction, 1);
  EXPECT_TRUE(before.unchanged());
}

TEST_P(ProgressOfSmoothing, CancelledAtTheEnd) {
  const RawSnapshot<DoubleMesh> before(mesh_);
  ProgressLog log([](const auto& call) { return call.fraction < 1; });
  EXPECT_THROW(vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, log.callable()), vcg_core::Cancelled);
  EXPECT_EQ(log.calls().back().fraction, 1);
  EXPECT_TRUE(before.unchanged());
}

TEST_P(ProgressOfSmoothing, IsNotCalledAgainAfterItCancelled) {
  make_long();
  int calls = 0;
  const auto progress = [&](double, const char*) { return ++calls < 2; };
  EXPECT_THROW(vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, progress), vcg_core::Cancelled);
  EXPECT_EQ(calls, 2);
}

TEST_P(ProgressOfSmoothing, ExceptionsPassThroughAndLeaveTheMesh) {
  make_long();
  const RawSnapshot<DoubleMesh> before(mesh_);
  const auto progress = [](double fraction, const char*) -> bool {
    if (fraction > 0.05) throw std::logic_error("from the caller");
    return true;
  };
  EXPECT_THROW(vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, progress), std::logic_error);
  EXPECT_TRUE(before.unchanged());
}

TEST_P(ProgressOfSmoothing, DoesNotChangeTheResult) {
  DoubleMesh other;
  fill(other, flat(mesh_));
  ProgressLog log;
  vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, log.callable());
  vcg_core::smooth(other, vcg_core::Method::paper, parameters_);
  for (std::size_t v = 0; v < mesh_.vert.size(); ++v) ASSERT_EQ(mesh_.vert[v].P(), other.vert[v].P());
}

TEST_P(ProgressOfSmoothing, MayBeEmpty) {
  EXPECT_NO_THROW(vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, vcg_core::Progress()));
}

// A bar that runs ahead tells nothing: after half a second of many, the first of ten passes is not done.
TEST_P(ProgressOfSmoothing, FollowsTheWork) {
  make_long();
  parameters_.iterations = 10;
  const auto start = ProgressLog::Clock::now();
  ProgressLog log([&](const auto& call) { return seconds(call.time - start) < 0.5; });
  EXPECT_THROW(vcg_core::smooth(mesh_, vcg_core::Method::paper, parameters_, log.callable()), vcg_core::Cancelled);
  EXPECT_GT(log.calls().back().fraction, 0);
  EXPECT_LT(log.calls().back().fraction, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Threads, ProgressOfSmoothing, testing::Values(1, 4), testing::PrintToStringParamName());

/// A time of its own, 60 ms later at every question: so that a short run makes many calls, on any machine.
class AskedTime {
 public:
  using Point = std::chrono::steady_clock::time_point;
  static Point ask() { return now_ += std::chrono::milliseconds(60); }
  static Point now() { return now_; }

 private:
  static inline Point now_;
};

struct CallInTime {
  double fraction;
  std::string stage;
  std::thread::id thread;
  AskedTime::Point time;
};

/// The calls of a whole run, but for the writing back.
std::vector<CallInTime> calls_of(vcg_core::Method method, int threads) {
  DoubleMesh mesh;
  fill(mesh, potato(5));  // 10,242 vertices
  std::vector<CallInTime> calls;
  const vcg_core::Progress progress = [&](double fraction, const char* stage) {
    calls.push_back({fraction, stage, std::this_thread::get_id(), AskedTime::now()});
    return true;
  };
  vcg_core::detail::Job job(progress, threads, AskedTime::ask);
  const vcg_core::detail::MeshArrays arrays = vcg_core::detail::read_mesh(vcg_core::view_of(mesh), job);
  vcg_core::detail::VertexAttributes none;
  vcg_core::detail::smooth_arrays(arrays, method, vcg_core::method_info(method).defaults, {}, none, job);
  job.finish();
  return calls;
}

class CallsOfProgress : public testing::TestWithParam<std::tuple<vcg_core::Method, int>> {
 protected:
  std::vector<CallInTime> calls_ = calls_of(std::get<0>(GetParam()), std::get<1>(GetParam()));
};

TEST_P(CallsOfProgress, RunFromZeroToOneNeverFallAndStayOnTheCallersThread) {
  ASSERT_GE(calls_.size(), 8u);
  EXPECT_EQ(calls_.front().fraction, 0);
  EXPECT_EQ(calls_.back().fraction, 1);
  std::size_t rises = 0;
  for (std::size_t k = 0; k < calls_.size(); ++k) {
    EXPECT_LE(calls_[k].fraction, 1);
    EXPECT_FALSE(calls_[k].stage.empty());
    EXPECT_EQ(calls_[k].thread, std::this_thread::get_id());
    if (k == 0) continue;
    EXPECT_GE(calls_[k].fraction, calls_[k - 1].fraction);
    rises += calls_[k].fraction > calls_[k - 1].fraction;
  }
  EXPECT_GE(rises, 3u);
}

TEST_P(CallsOfProgress, ComeAtMostTenTimesASecond) {
  for (std::size_t k = 1; k + 1 < calls_.size(); ++k)  // the last comes when the work is done
    EXPECT_GE((calls_[k].time - calls_[k - 1].time).count(),
              std::chrono::nanoseconds(std::chrono::milliseconds(100)).count());
}

std::vector<vcg_core::Method> all_methods() {
  std::vector<vcg_core::Method> all;
  for (const vcg_core::MethodInfo& info : vcg_core::methods()) all.push_back(info.method);
  return all;
}

INSTANTIATE_TEST_SUITE_P(MethodsAndThreads, CallsOfProgress,
                         testing::Combine(testing::ValuesIn(all_methods()), testing::Values(1, 4)),
                         [](const auto& instance) {
                           return vcg_core::method_name(std::get<0>(instance.param)) + "_" +
                                  std::to_string(std::get<1>(instance.param));
                         });

/// Seconds from the moment a user cancels, `wait` into the call, to the return of the call. Negative if the call was
/// over before.
template <class Call>
double time_to_cancel(double wait, const Call& call) {
  const auto start = ProgressLog::Clock::now();
  ProgressLog log([&](const ProgressLog::Call& c) { return seconds(c.time - start) < wait; });
  try {
    call(log.callable());
  } catch (const vcg_core::Cancelled&) {
    return seconds(ProgressLog::Clock::now() - start) - wait;
  }
  return -1;
}

/// The contract says 0.2 s. A machine busy with other work may take the processor away for longer, so the best of
/// several attempts counts.
template <class Call>
void expect_prompt_cancel(double wait, const Call& call) {
  double best = 1e9;
  for (int attempt = 0; attempt < 5 && best > 0.2; ++attempt) {
    const double time = time_to_cancel(wait, call);
    ASSERT_GE(time, 0) << "the call was over before it could be cancelled";
    best = std::min(best, time);
  }
  EXPECT_LE(best, 0.2);
}

// Each vertex has the whole mesh for a neighbourhood: the longest time between two vertices.
TEST(Cancelling, TakesEffectInTimeWhenNeighborhoodsAreTheWholeMesh) {
  DoubleMesh mesh;
  fill(mesh, potato(7));  // 163,842 vertices
  const RawSnapshot<DoubleMesh> before(mesh);
  SmoothingParameters parameters;
  parameters.rho = 1e6;
  for (const double wait : {0.3, 0.75}) {
    expect_prompt_cancel(wait, [&](const vcg_core::Progress& progress) {
      vcg_core::smooth(mesh, vcg_core::Method::paper, parameters, progress);
    });
    EXPECT_TRUE(before.unchanged());
  }
}

// While the mesh is read: the stages before the first vertex moves.
TEST(Cancelling, TakesEffectInTimeWhileALargeMeshIsRead) {
  DoubleMesh mesh;
  fill(mesh, potato(8));  // 655,362 vertices
  for (const double wait : {0.0, 0.1, 0.25})
    expect_prompt_cancel(wait, [&](const vcg_core::Progress& progress) {
      vcg_core::smooth(mesh, vcg_core::Method::paper, {}, progress);
    });
}

// Neighbourhoods wide enough that none is over before it can be cancelled.
TEST(Cancelling, TakesEffectInTimeInTheOtherFilters) {
  DoubleMesh mesh;
  fill(mesh, potato(8));
  std::mt19937 random(1);
  std::normal_distribution<double> noise(1, 0.001);  // about 0.2 |e|, as the guided filter leaves a clean mesh alone
  for (auto& vertex : mesh.vert) vertex.P() *= noise(random);
  for (const vcg_core::Method method :
       {vcg_core::Method::guided, vcg_core::Method::bmd, vcg_core::Method::jones, vcg_core::Method::hc}) {
    SCOPED_TRACE(vcg_core::method_name(method));
    SmoothingParameters parameters = vcg_core::method_info(method).defaults;
    parameters.sigma_c = 8;
    if (method == vcg_core::Method::hc) parameters.iterations = 200;
    for (const double wait : {0.5, 1.0, 1.7})
      expect_prompt_cancel(
          wait, [&](const vcg_core::Progress& progress) { vcg_core::smooth(mesh, method, parameters, progress); });
  }
}

TEST(Cancelling, TakesEffectInTimeInGeodesicDistances) {
  DoubleMesh mesh;
  fill(mesh, potato(8));
  for (const double wait : {0.1, 0.4, 0.7})
    expect_prompt_cancel(wait,
                         [&](const vcg_core::Progress& progress) { vcg_core::geodesic_distances(mesh, 0, progress); });
}

}  // namespace
