// SPDX-License-Identifier: GPL-3.0-or-later
#include "training_noise.h"

#include <mesh_tools/noise.h>

#include "training_mesh.h"

namespace training {

void add_some_noise(mesh_tools::Mesh& mesh, mesh_tools::Random& random) {
  static const std::vector<double> levels = {0.05, 0.1, 0.1, 0.15, 0.2, 0.2, 0.25, 0.3, 0.4, 0.5};
  mesh_tools::NoiseModel noise;
  noise.level = levels[choose(random, std::vector<double>(levels.size(), 1))] * between(random, 0.85, 1.15);
  noise.seed = static_cast<std::uint64_t>(random.uniform() * 1e9);
  switch (choose(random, {0.30, 0.13, 0.26, 0.10, 0.13, 0.08})) {
    case 0:
      break;
    case 1:
      noise.direction = mesh_tools::NoiseDirection::any;
      break;
    case 2:
      noise.correlation = between(random, 0.7, 3.5);
      break;
    case 3: {
      noise.camera = mesh.bbox.Center() + random.direction() * (mesh.bbox.Diag() * between(random, 0.8, 2));
      noise.correlation = random.uniform() < 0.6 ? between(random, 0.7, 3) : 0;
      break;
    }
    case 4:
      noise.share = between(random, 0.15, 0.5);
      noise.level *= 2;
      break;
    default:
      noise.level_far = noise.level * between(random, 0, 2);
      noise.axis = random.direction();
  }
  add_noise(mesh, noise);
}

}  // namespace training
