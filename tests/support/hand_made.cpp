// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/hand_made.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace test_support {

FlatMesh cube() {
  FlatMesh mesh;
  for (int v = 0; v < 8; ++v) mesh.points.emplace_back((v & 1) - 0.5, (v >> 1 & 1) - 0.5, (v >> 2 & 1) - 0.5);
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

FlatMesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

namespace {

FlatMesh icosahedron() {
  const double t = (1 + std::sqrt(5.0)) / 2;
  return {{{-1, t, 0},
           {1, t, 0},
           {-1, -t, 0},
           {1, -t, 0},
           {0, -1, t},
           {0, 1, t},
           {0, -1, -t},
           {0, 1, -t},
           {t, 0, -1},
           {t, 0, 1},
           {-t, 0, -1},
           {-t, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

FlatMesh split_in_four(const FlatMesh& mesh) {
  FlatMesh finer{mesh.points, {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle_of;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto [entry, is_new] = middle_of.try_emplace(std::minmax({a, b}), finer.points.size());
    if (is_new) finer.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
    return entry->second;
  };
  for (const Triangle& f : mesh.faces) {
    const std::size_t ab = middle(f[0], f[1]);
    const std::size_t bc = middle(f[1], f[2]);
    const std::size_t ca = middle(f[2], f[0]);
    for (const Triangle& small :
         {Triangle{f[0], ab, ca}, Triangle{f[1], bc, ab}, Triangle{f[2], ca, bc}, Triangle{ab, bc, ca}})
      finer.faces.push_back(small);
  }
  return finer;
}

}  // namespace

FlatMesh icosphere(int levels) {
  const auto onto_sphere = [](const Point& p) { return p / p.Norm(); };
  FlatMesh mesh = transformed(icosahedron(), onto_sphere);
  for (int level = 0; level < levels; ++level) mesh = transformed(split_in_four(mesh), onto_sphere);
  return mesh;
}

FlatMesh grid(std::size_t side) {
  FlatMesh mesh;
  const double step = 1.0 / static_cast<double>(side - 1);
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x)
      mesh.points.emplace_back(static_cast<double>(x) * step, static_cast<double>(y) * step, 0.0);
  for (std::size_t y = 0; y + 1 < side; ++y)
    for (std::size_t x = 0; x + 1 < side; ++x) {
      const std::size_t v = y * side + x;
      mesh.faces.push_back({v, v + 1, v + side + 1});
      mesh.faces.push_back({v, v + side + 1, v + side});
    }
  return mesh;
}

FlatMesh potato(int levels) {
  return transformed(icosphere(levels), [](const Point& p) {
    const double bump = 0.05 * std::sin(31 * p[0] + 1) * std::sin(37 * p[1] + 2) * std::sin(41 * p[2] + 3);
    return Point(1.3 * p[0], p[1] + 0.2 * p[0] * p[2], 0.8 * p[2] + 0.1 * p[0]) * (1 + bump);
  });
}

}  // namespace test_support
