// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/progress_log.h>

namespace test_support {

vcg_core::Progress ProgressLog::callable() {
  return [this](double fraction, const char* stage) {
    calls_.push_back({fraction, stage, std::this_thread::get_id(), Clock::now()});
    return !go_on_ || go_on_(calls_.back());
  };
}

}  // namespace test_support
