// SPDX-License-Identifier: GPL-3.0-or-later
#include "job.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include <vcg_core/errors.h>

namespace vcg_core::detail {

namespace {

constexpr std::chrono::milliseconds between_calls(100);

/// Thrown on a worker thread to leave its body after another thread failed; never leaves parallel().
struct Stopped {};

}  // namespace

struct Chunks::Shared {
  Job& job;
  std::size_t count;
  std::size_t grain;
  Loop loop;
  std::atomic<std::size_t> next_index{0};
  std::atomic<bool> stop{false};
  std::mutex failure_mutex;
  std::exception_ptr failure;

  Shared(Job& job_, std::size_t count_, std::size_t grain_, Loop loop_)
      : job(job_), count(count_), grain(grain_), loop(loop_) {}

  std::size_t chunk_count() const { return (count + grain - 1) / grain; }

  void run(const std::function<void(Chunks&)>& body, bool on_calling_thread) {
    try {
      Chunks chunks(*this, on_calling_thread);
      body(chunks);
    } catch (const Stopped&) {
    } catch (...) {
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
    }
  }
};

bool Chunks::next() {
  poll();
  const std::size_t index = shared_.next_index.fetch_add(1, std::memory_order_relaxed);
  if (index >= shared_.chunk_count()) return false;
  index_ = index;
  begin_ = index * shared_.grain;
  end_ = std::min(begin_ + shared_.grain, shared_.count);
  return true;
}

void Chunks::poll() {
  if (shared_.stop.load(std::memory_order_relaxed)) throw Stopped{};
  if (!on_calling_thread_) return;
  if (shared_.loop == Loop::minor) return shared_.job.poll();
  const std::size_t taken = std::min(shared_.next_index.load(std::memory_order_relaxed), shared_.chunk_count());
  shared_.job.report(static_cast<double>(taken) / static_cast<double>(shared_.chunk_count()));
}

StagePart::StagePart(Job& job, double begin, double end) : job_(job), begin_(job.stage_begin_), end_(job.stage_end_) {
  job.stage_begin_ = begin_ + begin * (end_ - begin_);
  job.stage_end_ = begin_ + end * (end_ - begin_);
}

StagePart::~StagePart() {
  job_.stage_begin_ = begin_;
  job_.stage_end_ = end_;
}

Job::Job(const Progress& progress, int threads, Clock now) : progress_(progress), threads_(threads), now_(now) {
  if (threads_ <= 0) threads_ = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

void Job::begin_stage(const char* name, double end_fraction) {
  const bool first = stage_end_ == 0;
  stage_ = name;
  stage_begin_ = stage_end_;
  stage_end_ = end_fraction;
  if (first) call(0.0);
}

bool Job::is_due() const { return progress_ && now_() - last_call_ >= between_calls; }

void Job::report(double stage_fraction) {
  if (is_due()) call(stage_begin_ + (stage_end_ - stage_begin_) * stage_fraction);
}

void Job::poll() {
  if (is_due()) call(last_fraction_);
}

void Job::finish() { call(1.0); }

void Job::call(double fraction) {
  if (!progress_) return;
  last_fraction_ = std::clamp(fraction, last_fraction_, 1.0);
  if (!progress_(last_fraction_, stage_)) throw Cancelled();
  last_call_ = now_();
}

void Job::parallel(std::size_t count, std::size_t grain, Loop loop, const std::function<void(Chunks&)>& body) {
  Chunks::Shared shared(*this, count, grain, loop);
  std::vector<std::thread> workers;
  const std::size_t wanted = std::min(static_cast<std::size_t>(threads_), shared.chunk_count());
  workers.reserve(wanted);
  try {
    while (workers.size() + 1 < wanted) workers.emplace_back([&] { shared.run(body, false); });
  } catch (const std::system_error&) {
    // The system has no more threads to give: those that started, and this one, do the work.
  } catch (const std::bad_alloc&) {
    // The same. Left uncaught, this would end the program, as threads are running.
  }
  shared.run(body, true);
  for (std::thread& worker : workers) worker.join();
  if (shared.failure) std::rethrow_exception(shared.failure);
}

}  // namespace vcg_core::detail
