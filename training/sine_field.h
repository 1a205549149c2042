// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include <mesh_tools/random.h>
#include <vcg/space/point3.h>

namespace training {

/// A smooth random vector field: a sum of waves.
class SineField {
 public:
  /// Adds `count` waves of about this angular frequency, with `amplitude` together.
  void add(mesh_tools::Random& random, double frequency, double amplitude, int count) {
    for (int i = 0; i < count; ++i) {
      const vcg::Point3d direction = random.direction();
      const double spread = 0.7 + 0.6 * random.uniform();
      const vcg::Point3d size(random.normal(), random.normal(), random.normal());
      waves_.push_back(
          {direction * (frequency * spread), size * (amplitude / std::sqrt(double(count))), 6.2832 * random.uniform()});
    }
  }

  vcg::Point3d operator()(const vcg::Point3d& p) const {
    vcg::Point3d sum(0, 0, 0);
    for (const Wave& wave : waves_) sum += wave.amplitude * std::sin(wave.frequency * p + wave.phase);
    return sum;
  }

 private:
  struct Wave {
    vcg::Point3d frequency, amplitude;
    double phase;
  };
  std::vector<Wave> waves_;
};

}  // namespace training
