// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_bar.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include "interrupt.h"
#include "terminal.h"

namespace anisosmooth {
namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

ProgressBar::ProgressBar(bool quiet) : enabled_(!quiet && stderr_is_terminal()), start_(seconds()) {}

ProgressBar::~ProgressBar() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

vcg_core::Progress ProgressBar::callback() {
  return [this](double fraction, const char* stage) {
    if (enabled_) show(fraction, stage);
    return !interrupted();
  };
}

void ProgressBar::show(double fraction, const std::string& stage) {
  if (!shown_ && seconds() - start_ < 1) return;
  shown_ = true;
  constexpr int width = 30;
  const int full = static_cast<int>(std::lround(fraction * width));
  const std::string bar = std::string(full, '#') + std::string(width - full, '.');
  std::fprintf(stderr, "\r\033[K[%s] %3.0f %% %s", bar.c_str(), 100 * fraction, stage.c_str());
  std::fflush(stderr);
}

}  // namespace anisosmooth
