// SPDX-License-Identifier: GPL-3.0-or-later
#include "height_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sine_field.h"
#include "training_mesh.h"

namespace training {

mesh_tools::Mesh height_field(mesh_tools::Random& random) {
  const int size = static_cast<int>(between(random, 50, 110));
  SineField relief;
  double frequency = 3, amplitude = between(random, 0.02, 0.2);
  const double decay = between(random, 0.3, 0.6);
  for (int octave = 0; octave < 5; ++octave, frequency *= 2, amplitude *= decay)
    relief.add(random, frequency, amplitude, 10);
  struct Dome {
    vcg::Point3d center;
    double radius, height;
    bool flat;
  };
  std::vector<Dome> domes;
  for (double k = between(random, 0, 7); k > 1; --k)
    domes.push_back({{random.uniform(), random.uniform(), 0},
                     between(random, 0.08, 0.35),
                     between(random, 0.05, 0.4),
                     random.uniform() < 0.4});
  const double unevenness = random.uniform() < 0.5 ? 0 : between(random, 0, 0.3);
  std::vector<vcg::Point3d> vertices;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      vcg::Point3d p((x + between(random, -unevenness, unevenness)) / size,
                     (y + between(random, -unevenness, unevenness)) / size, 0);
      double z = relief(p)[0];
      for (const Dome& dome : domes) {
        const double inside = 1 - (p - dome.center).SquaredNorm() / (dome.radius * dome.radius);
        if (inside > 0) z = std::max(z, dome.height * (dome.flat ? std::min(1.0, 4 * inside) : std::sqrt(inside)));
      }
      p[2] = z;
      vertices.push_back(p);
    }
  std::vector<std::array<std::size_t, 3>> faces;
  const double steepest = between(random, 2, 8) / size;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto [low, high] = std::minmax({vertices[a][2], vertices[b][2], vertices[c][2]});
    if (high - low < steepest) faces.push_back({a, b, c});
  };
  for (int y = 0; y + 1 < size; ++y)
    for (int x = 0; x + 1 < size; ++x) {
      const auto a = static_cast<std::size_t>(y * size + x), d = a + static_cast<std::size_t>(size);
      if (std::abs(vertices[a][2] - vertices[d + 1][2]) < std::abs(vertices[a + 1][2] - vertices[d][2])) {
        add(a, a + 1, d + 1);
        add(a, d + 1, d);
      } else {
        add(a, a + 1, d);
        add(a + 1, d + 1, d);
      }
    }
  mesh_tools::Mesh mesh;
  build(mesh, vertices, faces);
  return mesh;
}

}  // namespace training
