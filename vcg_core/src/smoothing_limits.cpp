// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/smoothing_limits.h>

#include <cmath>
#include <sstream>

#include <vcg_core/errors.h>

namespace vcg_core {

namespace {

void require(bool allowed, const char* name, double value, const char* what_is_allowed) {
  if (allowed) return;
  std::ostringstream message;
  message << name << " is " << value << "; it must be " << what_is_allowed;
  throw InvalidParameter(message.str());
}

}  // namespace

void SmoothingLimits::validate() const {
  require(std::isfinite(weld_distance) && weld_distance >= 0, "weld_distance", weld_distance,
          "a finite number, 0 or more");
  require(max_displacement >= 0, "max_displacement", max_displacement, "0 or more");
}

}  // namespace vcg_core
