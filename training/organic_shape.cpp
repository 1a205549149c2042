// SPDX-License-Identifier: GPL-3.0-or-later
#include "organic_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <mesh_tools/noise.h>
#include <vcg/complex/algorithms/create/platonic.h>

#include "sine_field.h"
#include "training_mesh.h"

namespace training {

namespace {

using mesh_tools::Mesh;
using mesh_tools::Random;

constexpr double pi = 3.14159265358979;

Mesh tube(Random& random) {
  const double radius = between(random, 0.25, 0.55);
  const int around = static_cast<int>(between(random, 40, 70));
  const int along = std::min(static_cast<int>(around / radius * between(random, 0.7, 1.1)), 12000 / around) & ~1;
  std::vector<vcg::Point3d> vertices;
  std::vector<std::array<std::size_t, 3>> faces;
  const auto at = [&](int i, int j) { return static_cast<std::size_t>((i % along) * around + j % around); };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j) {
      const double u = 2 * pi * i / along, v = 2 * pi * (j + 0.5 * (i % 2)) / around;
      const double r = 1 + radius * std::cos(v);
      vertices.emplace_back(r * std::cos(u), r * std::sin(u), radius * std::sin(v));
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (i % 2 == 1) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      } else {
        faces.push_back({a, b, d});
        faces.push_back({b, c, d});
      }
    }
  Mesh mesh;
  build(mesh, vertices, faces);
  return mesh;
}

Mesh ball(Random& random) {
  Mesh mesh;
  vcg::tri::Sphere(mesh, 5);
  const vcg::Point3d axes(between(random, 0.5, 1.5), between(random, 0.5, 1.5), between(random, 0.5, 1.5));
  for (auto& v : mesh.vert)
    for (int k = 0; k < 3; ++k) v.P()[k] *= axes[k];
  return mesh;
}

/// Median height of the vertices above their rings, in average edge lengths: what an estimate of noise would see.
double roughness(const Mesh& mesh, const std::vector<vcg::Point3d>& normal) {
  std::vector<vcg::Point3d> sum(mesh.vert.size(), vcg::Point3d(0, 0, 0));
  std::vector<double> count(mesh.vert.size(), 0), height;
  for (const auto& f : mesh.face)
    for (int k = 0; k < 3; ++k) {
      sum[vcg::tri::Index(mesh, f.cV(k))] += f.cP((k + 1) % 3);
      ++count[vcg::tri::Index(mesh, f.cV(k))];
    }
  for (std::size_t v = 0; v < mesh.vert.size(); ++v)
    if (count[v] > 0) height.push_back(std::abs((mesh.vert[v].cP() - sum[v] / count[v]) * normal[v]));
  std::nth_element(height.begin(), height.begin() + static_cast<std::ptrdiff_t>(height.size() / 2), height.end());
  return height[height.size() / 2] / 0.73 / mesh_tools::average_edge_length(mesh);
}

}  // namespace

Mesh organic_shape(Random& random) {
  const bool is_tube = random.uniform() < 0.35;
  Mesh mesh = is_tube ? tube(random) : ball(random);

  SineField bends, detail, mask;
  const double base = between(random, 0.2, 0.45), decay = between(random, 0.9, 1.8);
  bends.add(random, 2, base, 6);
  mask.add(random, 2, 1, 5);
  double frequency = 2;
  const int octaves = 3 + static_cast<int>(random.uniform() * 4);
  for (int octave = 1; octave < octaves; ++octave) {
    frequency *= 2;
    (octave < 2 ? bends : detail)
        .add(random, frequency, 0.5 * base * std::pow(2.0, -decay * octave) * between(random, 0.5, 1.5), 16);
  }
  for (auto& v : mesh.vert) v.P() += bends(v.P()) * (is_tube ? 0.35 : 0.8);

  const bool ridges = random.uniform() < 0.45;
  const vcg::Point3d ridge_direction = random.direction() * between(random, 4, 14);
  const double ridge_height = between(random, 0.02, 0.08), ridge_phase = between(random, 0, 6);
  const double least_detail = random.uniform() < 0.6 ? 0.6 : 0.5;
  const std::vector<vcg::Point3d> normal = mesh_tools::vertex_normals(mesh);
  std::vector<vcg::Point3d> smooth(mesh.vert.size());
  std::vector<double> height(mesh.vert.size());
  for (std::size_t v = 0; v < height.size(); ++v) {
    smooth[v] = mesh.vert[v].P();
    const vcg::Point3d m = mask(smooth[v]);
    height[v] = 1.7 * detail(smooth[v])[0] * (least_detail + (1 - least_detail) * std::tanh(2 * m[0]));
    if (ridges && m[1] > 0) height[v] += ridge_height * std::abs(std::sin(ridge_direction * smooth[v] + ridge_phase));
  }
  // Detail as rough as the finest that scans have, or less.
  const double most = 0.025 * std::pow(3.2, random.uniform());
  double least_scale = 0, most_scale = 1.5, scale = 1;
  for (int step = 0; step < 7; ++step) {
    for (std::size_t v = 0; v < height.size(); ++v) mesh.vert[v].P() = smooth[v] + normal[v] * (height[v] * scale);
    const double rough = roughness(mesh, normal);
    if (step == 0 && rough < most) break;
    (rough > most ? most_scale : least_scale) = scale;
    scale = (least_scale + most_scale) / 2;
  }
  return mesh;
}

}  // namespace training
