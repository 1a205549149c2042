// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>

#include <vcg/space/point3.h>

namespace mesh_tools {

/// Random numbers that are the same on every platform: std::mt19937_64 is fixed by the standard, the distributions of
/// the standard library are not, so they are made here.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();
  /// Normal with mean 0 and standard deviation 1 (Box and Muller 1958).
  double normal();
  /// A unit vector, uniform on the sphere.
  vcg::Point3d direction();

 private:
  std::mt19937_64 engine_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace mesh_tools
