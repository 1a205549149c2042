// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <utility>

#include <nanobind/nanobind.h>
#include <vcg_core/progress.h>

namespace anisosmooth_python {

/// What the core asks while it works without the interpreter's lock: takes the lock, lets signals such as Ctrl+C in,
/// and calls the user's `progress`, if there is one, with (fraction, stage). An exception there ends the work.
class Watch {
 public:
  explicit Watch(nanobind::object progress) : progress_(std::move(progress)) {}

  vcg_core::Progress callback() {
    return [this](double fraction, const char* stage) { return go_on(fraction, stage); };
  }

  /// Throws what a signal or `progress` threw, if they did.
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  bool go_on(double fraction, const char* stage) noexcept {
    const nanobind::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
      if (progress_.is_none()) return true;
      const nanobind::object answer = progress_(fraction, stage);
      return answer.is_none() || nanobind::cast<bool>(nanobind::bool_(answer));
    } catch (...) {
      exception_ = std::current_exception();
      return false;
    }
  }

  nanobind::object progress_;
  std::exception_ptr exception_;
};

/// Runs `work(progress)` without the interpreter's lock.
template <class Work>
auto run(nanobind::object progress, Work&& work) {
  Watch watch(std::move(progress));
  try {
    const nanobind::gil_scoped_release unlocked;
    return work(watch.callback());
  } catch (const vcg_core::Cancelled&) {
    watch.rethrow();
    throw;
  }
}

}  // namespace anisosmooth_python
