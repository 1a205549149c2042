// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>

#include <vcg_core/progress.h>

namespace tiles {

/// A stretch of a long work, as progress from one fraction of the whole to another. Asks about ten times a second.
class Stage {
 public:
  Stage(const vcg_core::Progress& progress, const char* name, double from, double to);

  /// To be called as often as is convenient.
  /// @throws vcg_core::Cancelled
  void at(double part);
  void at(std::size_t done, std::size_t of) { at(static_cast<double>(done) / static_cast<double>(of)); }

  /// A stretch of this one.
  Stage inner(double from, double to) const;
  /// The progress of a work that is a part of this stage.
  vcg_core::Progress part(double from, double to) const;

 private:
  const vcg_core::Progress& progress_;
  const char* name_;
  double from_, to_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace tiles
