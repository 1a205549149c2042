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

/// ", 3 min left", as soon as there is enough to judge by; nothing for work of seconds.
std::string remaining_time(double elapsed, double fraction) {
  constexpr double least_elapsed = 5, least_fraction = 0.02, worth_telling = 10;
  if (elapsed < least_elapsed || fraction < least_fraction) return "";
  const double left = elapsed * (1 - fraction) / fraction;
  if (left < worth_telling) return "";
  char text[32];
  if (left < 100)
    std::snprintf(text, sizeof text, ", %.0f s left", left);
  else if (left < 6000)
    std::snprintf(text, sizeof text, ", %.0f min left", left / 60);
  else
    std::snprintf(text, sizeof text, ", %.1f h left", left / 3600);
  return text;
}

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
  std::fprintf(stderr, "\r\033[K[%s] %3.0f %% %s%s", bar.c_str(), 100 * fraction, stage.c_str(),
               remaining_time(seconds() - start_, fraction).c_str());
  std::fflush(stderr);
}

}  // namespace anisosmooth
