// SPDX-License-Identifier: GPL-3.0-or-later
#include "stage.h"

#include <vcg_core/errors.h>

namespace tiles {

Stage::Stage(const vcg_core::Progress& progress, const char* name, double from, double to)
    : progress_(progress), name_(name), from_(from), to_(to) {
  at(0.0);
}

void Stage::at(double part) {
  if (!progress_) return;
  constexpr std::chrono::milliseconds between_calls(100);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < between_calls) return;
  last_ = now;
  if (!progress_(from_ + (to_ - from_) * part, name_)) throw vcg_core::Cancelled();
}

Stage Stage::inner(double from, double to) const {
  return {progress_, name_, from_ + (to_ - from_) * from, from_ + (to_ - from_) * to};
}

vcg_core::Progress Stage::part(double from, double to) const {
  if (!progress_) return {};
  return [this, from, to](double fraction, const char* /*stage*/) {
    return progress_(from_ + (to_ - from_) * (from + (to - from) * fraction), name_);
  };
}

}  // namespace tiles
