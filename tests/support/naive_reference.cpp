// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/naive_reference.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <support/naive_geodesics.h>

namespace test_support {

namespace {

bool has_repeated_vertex(const Triangle& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

/// Angle at p between the directions to a and b.
double angle_at(const Point& p, const Point& a, const Point& b) {
  const Point u = (a - p) / (a - p).Norm();
  const Point v = (b - p) / (b - p).Norm();
  return std::acos(std::clamp(u * v, -1.0, 1.0));
}

/// Angle-weighted mean of the normals of the faces around each vertex.
std::vector<Point> vertex_normals(const FlatMesh& mesh) {
  std::vector<Point> normal(mesh.points.size(), Point(0, 0, 0));
  for (const Triangle& f : mesh.faces) {
    const Point& a = mesh.points[f[0]];
    const Point& b = mesh.points[f[1]];
    const Point& c = mesh.points[f[2]];
    const Point cross = (b - a) ^ (c - a);
    const double longest = std::max({(b - a).Norm(), (c - b).Norm(), (a - c).Norm()});
    if (!(cross.Norm() > 1e-12 * longest * longest)) continue;  // a height that rounding left of none
    const Point face_normal = cross / cross.Norm();
    normal[f[0]] += face_normal * angle_at(a, b, c);
    normal[f[1]] += face_normal * angle_at(b, c, a);
    normal[f[2]] += face_normal * angle_at(c, a, b);
  }
  for (Point& n : normal) n = n.Norm() > 1e-9 ? n / n.Norm() : Point(0, 0, 0);  // below: normals that cancel
  return normal;
}

std::vector<bool> border_vertices(const FlatMesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> faces_of_edge;
  for (const Triangle& f : mesh.faces)
    if (!has_repeated_vertex(f))
      for (int k = 0; k < 3; ++k) ++faces_of_edge[std::minmax({f[k], f[(k + 1) % 3]})];
  std::vector<bool> border(mesh.points.size(), false);
  for (const auto& [edge, faces] : faces_of_edge)
    if (faces == 1) border[edge.first] = border[edge.second] = true;
  return border;
}

double gaussian(double x, double sigma) { return std::exp(-x * x / (2 * sigma * sigma)); }
double printed_gaussian(double x, double sigma) { return std::exp(-x * x / (sigma * sigma)); }

}  // namespace

NaiveReference::NaiveReference(const FlatMesh& mesh, double reach)
    : NaiveReference(mesh, reach, test_support::average_edge_length(welded(mesh))) {}

NaiveReference::NaiveReference(const FlatMesh& mesh, double reach, double e)
    : mesh_(welded(mesh)),
      first_(first_in_place(mesh)),
      e_(e),
      reach_(reach * e),
      normal_(vertex_normals(mesh_)),
      border_(border_vertices(mesh_)) {}

std::vector<double> NaiveReference::distances(std::size_t i) const {
  return naive_geodesics(mesh_, i, 1e-12 * e_, reach_);
}

NaiveVertex NaiveReference::smooth(std::size_t i, const vcg_core::SmoothingParameters& parameters) const {
  const double sigma_c = parameters.sigma_c * e_;
  const double sigma_s = parameters.sigma_s * e_;
  const double sigma_n = parameters.sigma_n;
  const double rho = parameters.rho * sigma_c;
  i = first_[i];
  const bool printed = parameters.gaussian == vcg_core::GaussianForm::printed;
  const auto w_c = [&](double x) { return printed ? printed_gaussian(x, sigma_c) : gaussian(x, sigma_c); };
  const auto w_s = [&](double x) { return printed ? printed_gaussian(x, sigma_s) : gaussian(x, sigma_s); };
  const auto w_n = [&](double x) { return gaussian(x, sigma_n); };

  NaiveVertex result;
  result.position = mesh_.points[i];
  result.clearance = std::numeric_limits<double>::infinity();
  const std::vector<double> distance = distances(i);
  double numerator = 0;
  double denominator = 0;
  for (std::size_t j = 0; j < mesh_.points.size(); ++j) {
    result.clearance = std::min(result.clearance, std::abs(distance[j] - rho) / e_);
    if (!(distance[j] < rho) || first_[j] != j) continue;
    result.neighborhood.push_back(j);
    if (normal_[j] == Point(0, 0, 0)) continue;  // has no height to offer
    const Point difference = mesh_.points[i] - mesh_.points[j];
    const double height = normal_[j] * difference;
    const double weight = w_c(difference.Norm()) * w_s(height) * w_n(1 - normal_[i] * normal_[j]);
    numerator += height * weight;
    denominator += weight;
  }
  const bool fixed = parameters.boundary == vcg_core::Boundary::fixed && border_[i];
  if (!fixed && normal_[i] != Point(0, 0, 0)) result.position -= normal_[i] * (numerator / denominator);
  return result;
}

FlatMesh naive_smooth(FlatMesh mesh, const vcg_core::SmoothingParameters& parameters, int passes) {
  const double e = average_edge_length(welded(mesh));
  for (int pass = 0; pass < passes; ++pass) {
    const FlatMesh before = mesh;
    const NaiveReference reference(before, std::numeric_limits<double>::infinity(), e);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i] = reference.smooth(i, parameters).position;
  }
  return mesh;
}

}  // namespace test_support
