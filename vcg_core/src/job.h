// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>

#include <vcg_core/progress.h>

namespace vcg_core::detail {

class Job;

/// Whether a parallel loop moves the progress of its stage. A minor one lets the caller cancel and leaves the fraction
/// as it is.
enum class Loop { main, minor };

/// One thread's view of a parallel loop: hands out chunks [begin, end) of the index range, in no particular order
/// among the threads. What a chunk computes must depend on its indices only, so that the result does not depend on the
/// number of threads.
class Chunks {
 public:
  /// Takes the next chunk; false when none is left. Throws when the job was cancelled or has failed elsewhere.
  bool next();
  std::size_t begin() const { return begin_; }
  std::size_t end() const { return end_; }
  std::size_t index() const { return index_; }

  /// To be called every few milliseconds of work inside a chunk, so that cancelling takes effect in time.
  void poll();

 private:
  friend class Job;
  struct Shared;
  Chunks(Shared& shared, bool on_calling_thread) : shared_(shared), on_calling_thread_(on_calling_thread) {}

  Shared& shared_;
  bool on_calling_thread_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t index_ = 0;
};

/// While it lives, what is reported fills only a part of the stage.
class StagePart {
 public:
  /// @param begin, end  shares of the stage
  StagePart(Job& job, double begin, double end);
  ~StagePart();
  StagePart(const StagePart&) = delete;
  StagePart& operator=(const StagePart&) = delete;

 private:
  Job& job_;
  const double begin_;  ///< of the whole stage, as the next
  const double end_;
};

/// One call of the library: its stages, its progress and its threads.
class Job {
 public:
  /// What tells the time; a test may bring its own.
  using Clock = std::chrono::steady_clock::time_point (*)();

  /// @param threads  0: one for each processor
  explicit Job(const Progress& progress, int threads = 0, Clock now = &std::chrono::steady_clock::now);

  /// Starts a stage that ends when `end_fraction` of the whole job is done. Throws Cancelled.
  void begin_stage(const char* name, double end_fraction);

  /// Reports progress inside the stage; on the calling thread only, as often as is convenient. Throws Cancelled.
  void report(double stage_fraction);

  /// Reports the end. The last moment to cancel; throws Cancelled.
  void finish();

  /// Gives the caller the opportunity to cancel, without any progress; as report otherwise.
  void poll();

  /// Runs `body` once on each thread, the calling thread among them; together the bodies work through [0, count) in
  /// chunks of `grain`. Rethrows the first exception after all threads have stopped.
  void parallel(std::size_t count, std::size_t grain, Loop loop, const std::function<void(Chunks&)>& body);
  void parallel(std::size_t count, std::size_t grain, const std::function<void(Chunks&)>& body) {
    parallel(count, grain, Loop::main, body);
  }

  /// Calls body(i) for each index below `count`, one after the other on the calling thread, and polls every few
  /// milliseconds: for what is not worth threads, and yet takes too long to wait for.
  template <class Body>
  void serial(std::size_t count, const Body& body) {
    constexpr std::size_t between_polls = 65536;  // a millisecond or two, where each index misses the cache
    for (std::size_t begin = 0; begin < count; begin += between_polls) {
      poll();
      const std::size_t end = (std::min)(count, begin + between_polls);
      for (std::size_t i = begin; i < end; ++i) body(i);
    }
  }

 private:
  friend class StagePart;

  bool is_due() const;
  void call(double fraction);

  const Progress& progress_;
  int threads_;
  Clock now_;
  const char* stage_ = "";
  double stage_begin_ = 0;
  double stage_end_ = 0;
  double last_fraction_ = 0;
  std::chrono::steady_clock::time_point last_call_;
};

}  // namespace vcg_core::detail
