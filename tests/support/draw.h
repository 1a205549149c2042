// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

namespace test_support {

/// A number in [low, high), from the whole range in every run: by itself the generator begins with the lowest.
template <class Number>
Number draw(Number low, Number high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

}  // namespace test_support
