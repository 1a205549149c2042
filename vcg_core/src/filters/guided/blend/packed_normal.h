// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace vcg_core::detail {

using Vec3f = Eigen::Vector3f;

/// A unit vector, or zero, in 8 bytes: coordinates of 21 bits, exact to 5e-7. A dozen candidates a face are most of
/// what the guided filter holds at its peak.
class PackedNormal {
 public:
  PackedNormal() = default;
  explicit PackedNormal(const Vec3f& normal)
      : bits_(coded(normal[0]) | coded(normal[1]) << 21 | coded(normal[2]) << 42) {}

  float x() const { return decoded(bits_ << 43); }
  float y() const { return decoded(bits_ << 22); }
  float z() const { return decoded(bits_ << 1); }
  Vec3f vector() const { return {x(), y(), z()}; }

 private:
  static constexpr float one = (1 << 20) - 1;

  /// To the nearest number, halves away from zero.
  static std::uint64_t coded(float coordinate) {
    const float scaled = coordinate * one;
    const auto rounded = static_cast<std::int64_t>(scaled + (scaled < 0 ? -0.5F : 0.5F));
    return static_cast<std::uint64_t>(rounded) & 0x1fffff;
  }
  /// @param highest  the number in the highest bits
  static float decoded(std::uint64_t highest) {
    return static_cast<float>(static_cast<std::int64_t>(highest) >> 43) * (1 / one);
  }

  std::uint64_t bits_ = 0;
};

}  // namespace vcg_core::detail
