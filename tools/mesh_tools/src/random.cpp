// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/random.h>

#include <cmath>

namespace mesh_tools {
namespace {
constexpr double pi = 3.14159265358979323846;
}

double Random::uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));  // 1 - u lies in (0, 1]
  const double angle = 2 * pi * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

vcg::Point3d Random::direction() {
  const double z = 2 * uniform() - 1;
  const double angle = 2 * pi * uniform();
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace mesh_tools
