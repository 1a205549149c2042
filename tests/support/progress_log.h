// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <vcg_core/progress.h>

namespace test_support {

/// Writes down every call of a progress callable, and cancels when told to.
class ProgressLog {
 public:
  using Clock = std::chrono::steady_clock;

  struct Call {
    double fraction;
    std::string stage;
    std::thread::id thread;
    Clock::time_point time;
  };

  /// @param go_on  asked after each call, which is the last of the log; returning false cancels
  explicit ProgressLog(std::function<bool(const Call&)> go_on = {}) : go_on_(std::move(go_on)) {}
  ProgressLog(const ProgressLog&) = delete;
  ProgressLog& operator=(const ProgressLog&) = delete;

  /// What to hand to the library. The log must outlive the call.
  vcg_core::Progress callable();

  const std::vector<Call>& calls() const { return calls_; }

 private:
  std::function<bool(const Call&)> go_on_;
  std::vector<Call> calls_;
};

}  // namespace test_support
