// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vcg/complex/algorithms/update/bounding.h>

#include <mesh_tools/shapes.h>

#include "../measure/closest_point.h"

namespace mesh_tools::shapes {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double torus_major = 1, torus_minor = 0.4;

/// The finer mesh has this many times the vertices.
constexpr std::size_t refinement = 4;

vcg::Point3d on_circle_of_torus(const vcg::Point3d& p) {
  const double radius = std::hypot(p[0], p[1]);
  return radius > 0 ? vcg::Point3d(p[0], p[1], 0) * (torus_major / radius) : vcg::Point3d(torus_major, 0, 0);
}

/// On which side of the line through a and b, as seen from a, the point (x, y) lies: the same value, but for its sign,
/// from both sides of an edge, so that no column passes between two triangles or counts both.
bool is_left(const vcg::Point3d& a, const vcg::Point3d& b, double x, double y) {
  const bool swapped = std::make_pair(b[0], b[1]) < std::make_pair(a[0], a[1]);
  const vcg::Point3d &p = swapped ? b : a, &q = swapped ? a : b;
  const bool left = (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) > 0;
  return left != swapped;
}

/// Indices of the ascending values within [low, high].
std::pair<std::size_t, std::size_t> range_of(const std::vector<double>& values, double low, double high) {
  return {static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), low) - values.begin()),
          static_cast<std::size_t>(std::upper_bound(values.begin(), values.end(), high) - values.begin())};
}

}  // namespace

Solid::Solid(const std::string& shape, std::size_t vertices, double tilt) : tilt_(tilt * pi / 180) {
  // The plate's thickness is the edge length of its mesh.
  mesh_ = make_shape(shape, shape == "thin_plate" ? vertices : refinement * vertices);
  for (auto& vertex : mesh_.vert) vertex.P() = turned(vertex.cP(), 1);
  vcg::tri::UpdateBounding<Mesh>::Box(mesh_);
  if (shape == "sphere") {
    formula_ = {[](const vcg::Point3d& p) { return p.SquaredNorm() < 1; },
                [](const vcg::Point3d& p) { return p.Norm() > 0 ? p / p.Norm() : vcg::Point3d(0, 0, 1); }};
  } else if (shape == "torus") {
    formula_ = {[](const vcg::Point3d& p) { return (p - on_circle_of_torus(p)).Norm() < torus_minor; },
                [](const vcg::Point3d& p) {
                  const vcg::Point3d centre = on_circle_of_torus(p), out = p - centre;
                  const double length = out.Norm();
                  return centre + (length > 0 ? out / length : vcg::Point3d(0, 0, 1)) * torus_minor;
                }};
  } else {
    surface_ = std::make_unique<SurfaceDistance>(mesh_);
  }
}

Solid::~Solid() = default;
Solid::Solid(Solid&&) noexcept = default;

/// About the axis (1, 2, 3), by Rodrigues' formula.
vcg::Point3d Solid::turned(const vcg::Point3d& p, double direction) const {
  if (tilt_ == 0) return p;
  const vcg::Point3d axis = vcg::Point3d(1, 2, 3) / std::sqrt(14.0);
  const double angle = direction * tilt_, cosine = std::cos(angle);
  return p * cosine + (axis ^ p) * std::sin(angle) + axis * ((axis * p) * (1 - cosine));
}

vcg::Point3d Solid::shadows() const {
  vcg::Point3d sum(0, 0, 0);
  for (const auto& face : mesh_.face) {
    const vcg::Point3d area = (face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0));
    for (int k = 0; k < 3; ++k) sum[k] += std::abs(area[k]) / 2;
  }
  return sum;
}

/// For each column the heights at which it passes through the surface, ascending.
std::vector<std::vector<double>> Solid::crossings(const std::vector<double>& x, const std::vector<double>& y) const {
  std::vector<std::vector<double>> found(x.size() * y.size());
  for (const auto& face : mesh_.face) {
    const vcg::Point3d &a = face.cP(0), &b = face.cP(1), &c = face.cP(2);
    const vcg::Point3d normal = (b - a) ^ (c - a);
    if (normal[2] == 0) continue;
    const auto [left, right] = range_of(x, std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}));
    const auto [front, back] = range_of(y, std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}));
    for (std::size_t j = front; j < back; ++j)
      for (std::size_t i = left; i < right; ++i) {
        const bool side = is_left(a, b, x[i], y[j]);
        if (side != is_left(b, c, x[i], y[j]) || side != is_left(c, a, x[i], y[j])) continue;
        found[j * x.size() + i].push_back(a[2] - (normal[0] * (x[i] - a[0]) + normal[1] * (y[j] - a[1])) / normal[2]);
      }
  }
  for (std::vector<double>& column : found) std::sort(column.begin(), column.end());
  return found;
}

std::vector<bool> Solid::contains(const std::vector<double>& x, const std::vector<double>& y,
                                  const std::vector<double>& heights) const {
  std::vector<bool> inside(x.size() * y.size() * heights.size());
  if (formula_.contains) {
    std::size_t at = 0;
    for (const double py : y)
      for (const double px : x)
        for (const double pz : heights) inside[at++] = formula_.contains(turned(vcg::Point3d(px, py, pz), -1));
    return inside;
  }
  const std::vector<std::vector<double>> found = crossings(x, y);
  for (std::size_t column = 0; column < found.size(); ++column)
    for (std::size_t pair = 0; pair + 1 < found[column].size(); pair += 2) {
      const auto [low, high] = range_of(heights, found[column][pair], found[column][pair + 1]);
      for (std::size_t k = low; k < high; ++k) inside[column * heights.size() + k] = true;
    }
  return inside;
}

vcg::Point3d Solid::nearest(const vcg::Point3d& p) const {
  return formula_.nearest ? turned(formula_.nearest(turned(p, -1)), 1) : surface_->nearest(p);
}

}  // namespace mesh_tools::shapes
