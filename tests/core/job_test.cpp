// SPDX-License-Identifier: GPL-3.0-or-later
// The core's job: stages, progress and parallel loops.

#include <job.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <support/progress_log.h>
#include <vcg_core/errors.h>

namespace {

using test_support::ProgressLog;
using vcg_core::detail::Chunks;
using vcg_core::detail::Job;
using vcg_core::detail::Loop;
using vcg_core::detail::StagePart;

/// Long enough for the next report to be passed on.
void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(110)); }

TEST(Job, MapsFractionsOfStagesToThoseOfTheJob) {
  ProgressLog log;
  const vcg_core::Progress progress = log.callable();
  Job job(progress, 1);
  job.begin_stage("first", 0.2);
  wait();
  job.report(0.5);
  job.begin_stage("second", 1.0);
  wait();
  job.report(0.25);
  job.finish();
  ASSERT_EQ(log.calls().size(), 4u);
  const double fractions[] = {0, 0.1, 0.4, 1};
  const char* const stages[] = {"first", "first", "second", "second"};
  for (int k = 0; k < 4; ++k) {
    EXPECT_DOUBLE_EQ(log.calls()[k].fraction, fractions[k]);
    EXPECT_EQ(log.calls()[k].stage, stages[k]);
  }
}

TEST(Job, MapsFractionsOfPartsToThoseOfTheStage) {
  ProgressLog log;
  const vcg_core::Progress progress = log.callable();
  Job job(progress, 1);
  job.begin_stage("stage", 0.8);
  {
    const StagePart part(job, 0.25, 0.5);
    wait();
    job.report(0.5);
  }
  wait();
  job.report(0.75);
  ASSERT_EQ(log.calls().size(), 3u);
  EXPECT_DOUBLE_EQ(log.calls()[1].fraction, 0.8 * 0.375);
  EXPECT_DOUBLE_EQ(log.calls()[2].fraction, 0.8 * 0.75);
}

TEST(Job, NeverFallsAndNeverPassesOne) {
  ProgressLog log;
  const vcg_core::Progress progress = log.callable();
  Job job(progress, 1);
  job.begin_stage("stage", 1.0);
  for (const double fraction : {0.5, 0.25, 7.0, 0.75}) {
    wait();
    job.report(fraction);
  }
  ASSERT_EQ(log.calls().size(), 5u);
  EXPECT_EQ(log.calls()[2].fraction, 0.5);
  EXPECT_EQ(log.calls()[3].fraction, 1);
  EXPECT_EQ(log.calls()[4].fraction, 1);
}

TEST(Job, PassesOnAtMostTenReportsASecond) {
  ProgressLog log;
  const vcg_core::Progress progress = log.callable();
  Job job(progress, 1);
  job.begin_stage("stage", 1.0);
  const auto start = ProgressLog::Clock::now();
  while (ProgressLog::Clock::now() - start < std::chrono::milliseconds(350)) job.report(0.5);
  EXPECT_GE(log.calls().size(), 2u);
  for (std::size_t k = 1; k < log.calls().size(); ++k)
    EXPECT_GE(std::chrono::duration<double>(log.calls()[k].time - log.calls()[k - 1].time).count(), 0.099);
}

TEST(Job, MinorLoopsPollAndLeaveTheFraction) {
  ProgressLog log;
  const vcg_core::Progress progress = log.callable();
  Job job(progress, 1);
  job.begin_stage("stage", 1.0);
  job.parallel(3, 1, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next()) wait();
  });
  ASSERT_GE(log.calls().size(), 3u);
  for (const auto& call : log.calls()) EXPECT_EQ(call.fraction, 0);
}

class ParallelLoop : public testing::TestWithParam<int> {};

TEST_P(ParallelLoop, VisitsEveryIndexOnce) {
  const vcg_core::Progress progress;
  Job job(progress, GetParam());
  for (const std::size_t count : {0, 1, 63, 64, 65, 1000})
    for (const std::size_t grain : {1, 7, 64, 5000}) {
      std::vector<std::atomic<int>> visits(count);
      job.parallel(count, grain, [&](Chunks& chunks) {
        while (chunks.next()) {
          EXPECT_EQ(chunks.begin(), chunks.index() * grain);
          for (std::size_t i = chunks.begin(); i < chunks.end(); ++i) ++visits[i];
        }
      });
      for (const auto& v : visits) ASSERT_EQ(v, 1);
    }
}

TEST_P(ParallelLoop, RethrowsWhatABodyThrowsAfterAllHaveStopped) {
  const vcg_core::Progress progress;
  Job job(progress, GetParam());
  std::atomic<int> inside{0};
  try {
    job.parallel(100000, 1, [&](Chunks& chunks) {
      ++inside;
      struct Leave {
        std::atomic<int>& count;
        ~Leave() { --count; }
      } leave{inside};
      while (chunks.next())
        if (chunks.begin() == 500) throw std::runtime_error("at 500");
    });
    ADD_FAILURE() << "nothing thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "at 500");
  }
  EXPECT_EQ(inside, 0);
}

TEST_P(ParallelLoop, StopsOnAllThreadsWhenCancelled) {
  ProgressLog log([](const auto& call) { return call.fraction == 0; });
  const vcg_core::Progress progress = log.callable();
  Job job(progress, GetParam());
  job.begin_stage("stage", 1.0);
  std::atomic<std::size_t> steps{0};
  const auto slow_loop = [&](Chunks& chunks) {
    while (chunks.next()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++steps;
    }
  };
  EXPECT_THROW(job.parallel(100000, 1, slow_loop), vcg_core::Cancelled);
  EXPECT_LT(steps, 50000u);
  for (const auto& call : log.calls()) EXPECT_EQ(call.thread, std::this_thread::get_id());
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelLoop, testing::Values(1, 2, 3, 8), testing::PrintToStringParamName());

TEST(Job, UsesAsManyThreadsAsAskedAndOneForEachProcessorByDefault) {
  const vcg_core::Progress progress;
  const auto bodies = [&](int threads) {
    Job job(progress, threads);
    std::atomic<unsigned> count{0};
    job.parallel(1000, 1, [&](Chunks& chunks) {
      ++count;
      while (chunks.next()) {
      }
    });
    return count.load();
  };
  EXPECT_EQ(bodies(5), 5u);
  EXPECT_EQ(bodies(0), std::max(1u, std::thread::hardware_concurrency()));
}

TEST(Job, SerialLoopsVisitEveryIndexInOrderAndPoll) {
  for (const std::size_t count : {0, 1, 65535, 65536, 65537, 300000}) {
    std::size_t polls = 0;
    const vcg_core::Progress progress = [&](double, const char*) { return ++polls > 0; };
    static std::chrono::steady_clock::time_point now;
    Job job(progress, 1, [] { return now += std::chrono::seconds(1); });
    std::size_t next = 0;
    job.serial(count, [&](std::size_t i) { next += i == next ? 1 : 0; });
    EXPECT_EQ(next, count);
    EXPECT_EQ(polls, (count + 65535) / 65536);
  }
}

}  // namespace
