// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <vcg_core/progress.h>

namespace anisosmooth {

/// Shows progress as a bar on stderr if that is a terminal, and stops the work when the user interrupts. Nothing is
/// shown of work that is done within a second.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// A callable that refers to this bar.
  vcg_core::Progress callback();

 private:
  void show(double fraction, const std::string& stage);

  bool enabled_;
  bool shown_ = false;
  double start_;
};

}  // namespace anisosmooth
