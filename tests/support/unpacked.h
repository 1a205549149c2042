// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/guided/four_normals.h"

namespace test_support {

/// Static, as what it calls is another function in each source.
static inline vcg_core::detail::Vec3 unpacked(vcg_core::detail::PackedNormal normal) {
  vcg_core::detail::UnitNormal unit;
  vcg_core::detail::unpack(&normal, 1, &unit);
  return vcg_core::detail::in_double(unit);
}

}  // namespace test_support
