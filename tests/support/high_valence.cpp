// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/high_valence.h>

#include <cmath>
#include <numeric>

namespace test_support {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Adds a circle of n vertices; gives the index of the first.
std::size_t add_circle(FlatMesh& mesh, std::size_t n, double radius, double z) {
  const std::size_t first = mesh.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double phi = 2 * pi * static_cast<double>(k) / static_cast<double>(n);
    mesh.points.emplace_back(radius * std::cos(phi), radius * std::sin(phi), z);
  }
  return first;
}

/// Adds a vertex and joins it to a circle, looking up or down.
void add_hub(FlatMesh& mesh, std::size_t circle, std::size_t n, double z, bool up) {
  const std::size_t hub = mesh.points.size();
  mesh.points.emplace_back(0, 0, z);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t a = circle + k;
    const std::size_t b = circle + (k + 1) % n;
    if (up)
      mesh.faces.push_back({hub, a, b});
    else
      mesh.faces.push_back({hub, b, a});
  }
}

/// Joins two circles of n vertices each by a strip that looks outwards.
void add_strip(FlatMesh& mesh, std::size_t below, std::size_t above, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    mesh.faces.push_back({below + k, below + next, above + next});
    mesh.faces.push_back({below + k, above + next, above + k});
  }
}

/// The triangles of a convex polygon of n corners, counted from 0.
std::vector<Triangle> clip_ears(std::size_t n, bool around_one_corner) {
  std::vector<Triangle> triangles;
  std::vector<std::size_t> left(n);
  std::iota(left.begin(), left.end(), std::size_t(0));
  if (around_one_corner) {
    for (std::size_t k = 1; k + 1 < n; ++k) triangles.push_back({0, k, k + 1});
    return triangles;
  }
  while (left.size() > 2) {
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < left.size(); k += 2) {
      kept.push_back(left[k]);
      if (k + 1 < left.size() && left.size() > 2)
        triangles.push_back({left[k], left[k + 1], left[(k + 2) % left.size()]});
    }
    left = kept;
  }
  return triangles;
}

}  // namespace

FlatMesh fan(std::size_t n) {
  FlatMesh mesh;
  add_hub(mesh, add_circle(mesh, n, 1, 0), n, 0, true);
  return mesh;
}

FlatMesh cone(std::size_t n, double height) {
  FlatMesh mesh;
  const std::size_t rim = add_circle(mesh, n, 1, 0);
  add_hub(mesh, rim, n, height, true);
  add_hub(mesh, rim, n, 0, false);
  return mesh;
}

FlatMesh prism(std::size_t n) {
  FlatMesh mesh;
  const std::size_t below = add_circle(mesh, n, 1, 0);
  const std::size_t above = add_circle(mesh, n, 1, 1);
  add_strip(mesh, below, above, n);
  add_hub(mesh, below, n, 0, false);
  add_hub(mesh, above, n, 1, true);
  return mesh;
}

FlatMesh ear_clipped_prism(std::size_t n, bool around_one_corner) {
  FlatMesh mesh;
  const std::size_t below = add_circle(mesh, n, 1, 0);
  const std::size_t above = add_circle(mesh, n, 1, 1);
  add_strip(mesh, below, above, n);
  for (const Triangle& t : clip_ears(n, around_one_corner)) {
    mesh.faces.push_back({below + t[0], below + t[2], below + t[1]});
    mesh.faces.push_back({above + t[0], above + t[1], above + t[2]});
  }
  return mesh;
}

FlatMesh umbrella(std::size_t n) {
  FlatMesh mesh = fan(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double t = static_cast<double>(k);
    mesh.points[k] *= 1 + 0.3 * std::sin(7.3 * t);
    mesh.points[k][2] = 0.2 * std::cos(4.1 * t) - 0.3;
  }
  return mesh;
}

FlatMesh globe(std::size_t n, std::size_t rings) {
  FlatMesh mesh;
  std::vector<std::size_t> circle;
  for (std::size_t r = 1; r <= rings; ++r) {
    const double theta = pi * static_cast<double>(r) / static_cast<double>(rings + 1);
    circle.push_back(add_circle(mesh, n, std::sin(theta), -std::cos(theta)));
  }
  for (std::size_t r = 0; r + 1 < rings; ++r) add_strip(mesh, circle[r], circle[r + 1], n);
  add_hub(mesh, circle.front(), n, -1, false);
  add_hub(mesh, circle.back(), n, 1, true);
  return mesh;
}

std::vector<std::pair<std::string, FlatMesh>> high_valence_meshes(std::size_t n) {
  return {{"fan", fan(n)},
          {"flat_cone", cone(n, 0.2)},
          {"steep_cone", cone(n, 5)},
          {"prism", prism(n)},
          {"prism_clipped_around_a_corner", ear_clipped_prism(n, true)},
          {"prism_clipped_in_turn", ear_clipped_prism(n, false)},
          {"umbrella", umbrella(n)},
          {"globe", globe(n, 12)}};
}

}  // namespace test_support
