// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

namespace vcg_core::detail {

/// A number from 0 to 4, to within 4e-5, in 2 bytes; larger ones become 4.
class PackedNumber {
 public:
  PackedNumber() = default;
  explicit PackedNumber(float x) : bits_(static_cast<std::uint16_t>(std::min(65535.0F, x * one + 0.5F))) {}

  float value() const { return static_cast<float>(bits_) * (1 / one); }

 private:
  static constexpr float one = 16384;

  std::uint16_t bits_ = 0;
};

}  // namespace vcg_core::detail
