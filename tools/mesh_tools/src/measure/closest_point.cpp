// SPDX-License-Identifier: GPL-3.0-or-later
#include "closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mesh_tools {
namespace {

constexpr int leaf_size = 4;

vcg::Point3d nearest_of_segment(const vcg::Point3d& p, const vcg::Point3d& a, const vcg::Point3d& b) {
  const vcg::Point3d edge = b - a;
  const double length = edge.SquaredNorm();
  const double t = length > 0 ? std::clamp(((p - a) * edge) / length, 0.0, 1.0) : 0.0;
  return a + edge * t;
}

double squared_distance_to_segment(const vcg::Point3d& p, const vcg::Point3d& a, const vcg::Point3d& b) {
  return (p - nearest_of_segment(p, a, b)).SquaredNorm();
}

/// Whether the foot of the perpendicular from p lies within the triangle, which has an area.
bool is_above(const vcg::Point3d& p, const std::array<vcg::Point3d, 3>& t, const vcg::Point3d& normal) {
  bool above = normal.SquaredNorm() > 0;
  for (int k = 0; k < 3 && above; ++k) above = (normal ^ (t[(k + 1) % 3] - t[k])) * (p - t[k]) >= 0;
  return above;
}

double squared_distance_to_box(const vcg::Point3d& p, const vcg::Point3d& low, const vcg::Point3d& high) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double outside = std::max({low[k] - p[k], 0.0, p[k] - high[k]});
    sum += outside * outside;
  }
  return sum;
}

}  // namespace

double squared_distance_to_triangle(const vcg::Point3d& p, const std::array<vcg::Point3d, 3>& t) {
  const vcg::Point3d normal = (t[1] - t[0]) ^ (t[2] - t[0]);
  if (is_above(p, t, normal)) {
    const double height = normal * (p - t[0]);
    return height * height / normal.SquaredNorm();
  }
  return std::min({squared_distance_to_segment(p, t[0], t[1]), squared_distance_to_segment(p, t[1], t[2]),
                   squared_distance_to_segment(p, t[2], t[0])});
}

vcg::Point3d nearest_of_triangle(const vcg::Point3d& p, const std::array<vcg::Point3d, 3>& t) {
  const vcg::Point3d normal = (t[1] - t[0]) ^ (t[2] - t[0]);
  if (is_above(p, t, normal)) return p - normal * (normal * (p - t[0]) / normal.SquaredNorm());
  vcg::Point3d nearest = nearest_of_segment(p, t[0], t[1]);
  for (int k = 1; k < 3; ++k) {
    const vcg::Point3d other = nearest_of_segment(p, t[k], t[(k + 1) % 3]);
    if ((p - other).SquaredNorm() < (p - nearest).SquaredNorm()) nearest = other;
  }
  return nearest;
}

SurfaceDistance::SurfaceDistance(const Mesh& mesh) {
  std::vector<vcg::Point3d> centres;
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    triangles_.push_back({face.cP(0), face.cP(1), face.cP(2)});
    centres.push_back((face.cP(0) + face.cP(1) + face.cP(2)) / 3);
  }
  std::vector<int> order(triangles_.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(triangles_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<int>(order.size()), centres, order);
  std::vector<Triangle> sorted;
  sorted.reserve(triangles_.size());
  for (int i : order) sorted.push_back(triangles_[i]);
  triangles_ = std::move(sorted);
}

void SurfaceDistance::build(int node, int first, int last, std::vector<vcg::Point3d>& centres,
                            std::vector<int>& order) {
  vcg::Box3d box, centre_box;
  for (int i = first; i < last; ++i) {
    for (const vcg::Point3d& p : triangles_[order[i]]) box.Add(p);
    centre_box.Add(centres[order[i]]);
  }
  nodes_[node].low = box.min;
  nodes_[node].high = box.max;
  if (last - first <= leaf_size) {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  const int axis = centre_box.MaxDim();
  const int middle = first + (last - first) / 2;
  std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
                   [&](int a, int b) { return centres[a][axis] < centres[b][axis]; });
  const int children = static_cast<int>(nodes_.size());
  nodes_[node].first = children;
  nodes_[node].count = 0;
  nodes_.resize(nodes_.size() + 2);
  build(children, first, middle, centres, order);
  build(children + 1, middle, last, centres, order);
}

double SurfaceDistance::operator()(const vcg::Point3d& point, double bound) const {
  return std::sqrt(search(point, bound * bound).squared_distance);
}

vcg::Point3d SurfaceDistance::nearest(const vcg::Point3d& point) const {
  return nearest_of_triangle(point, triangles_[search(point, std::numeric_limits<double>::infinity()).triangle]);
}

SurfaceDistance::Nearest SurfaceDistance::search(const vcg::Point3d& point, double squared_bound) const {
  struct Visit {
    int node;
    double squared_distance;
  };
  Nearest best{squared_bound, -1};
  std::array<Visit, 128> stack;  // the tree is balanced: its depth is at most 31
  std::size_t depth = 0;
  stack[depth++] = {0, squared_distance_to_box(point, nodes_[0].low, nodes_[0].high)};
  while (depth > 0) {
    const Visit visit = stack[--depth];
    if (visit.squared_distance >= best.squared_distance) continue;
    const Node& node = nodes_[visit.node];
    for (int i = node.first; i < node.first + node.count; ++i) {
      const double squared_distance = squared_distance_to_triangle(point, triangles_[i]);
      if (squared_distance < best.squared_distance) best = {squared_distance, i};
    }
    if (node.count > 0) continue;
    Visit nearer{node.first, squared_distance_to_box(point, nodes_[node.first].low, nodes_[node.first].high)};
    Visit farther{node.first + 1,
                  squared_distance_to_box(point, nodes_[node.first + 1].low, nodes_[node.first + 1].high)};
    if (farther.squared_distance < nearer.squared_distance) std::swap(nearer, farther);
    stack[depth++] = farther;
    stack[depth++] = nearer;
  }
  return best;
}

}  // namespace mesh_tools
