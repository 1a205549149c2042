// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace apply_mlx {

/// While it lives, SIGINT, SIGTERM and SIGHUP wait, so that what was written aside can be removed; when it ends, they
/// do what they do otherwise. One at a time.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether one of them has come.
  static bool any();

 private:
  static constexpr int numbers_[] = {SIGINT, SIGTERM, SIGHUP};
  struct sigaction before_[3] = {};
};

}  // namespace apply_mlx
