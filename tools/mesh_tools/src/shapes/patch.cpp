// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>

#include "region.h"

namespace mesh_tools::shapes {
namespace {

/// Nearest that a point inside may lie to the boundary, in edge lengths. Over one half, so that the circle over a
/// boundary edge stays empty and Delaunay keeps the edge.
constexpr double clearance = 0.6;

/// Irregular points about h apart: a triangular lattice whose points are shaken by at most a quarter of h.
std::vector<Point2> scatter_uniform(const Region& region, double h, Random& random) {
  std::vector<Point2> points;
  const double row_height = h * std::sqrt(0.75);
  const double distance = std::min(clearance * h, region.longest_edge());
  double y = region.low().y;
  for (int row = 0; y <= region.high().y; ++row) {
    double x = region.low().x + (row % 2 ? 0.5 * h : 0.0);
    while (x <= region.high().x) {
      const double radius = 0.25 * h * std::sqrt(random.uniform());
      const double angle = 6.283185307179586 * random.uniform();
      const Point2 p{x + radius * std::cos(angle), y + radius * std::sin(angle)};
      if (region.contains(p) && !region.is_near_boundary(p, distance)) points.push_back(p);
      x += h;
    }
    y += row_height;
  }
  return points;
}

/// Points as far apart as the spacing at their place asks: one in each leaf of a quadtree that follows it.
class QuadtreeScatter {
 public:
  QuadtreeScatter(const Region& region, const Patch& patch, const Spacing& spacing, Random& random)
      : region_(region), patch_(patch), spacing_(spacing), random_(random) {}

  std::vector<Point2> points() {
    const double side = std::max(region_.high().x - region_.low().x, region_.high().y - region_.low().y);
    split(region_.low(), side);
    return std::move(points_);
  }

 private:
  void split(const Point2& low, double side) {
    // A square leaf of side s holds one point; in a triangular lattice of spacing h each point has 0.866 h^2. Between
    // s and 2 s the tree has no choice, hence the random rounding: it gives the right density on average.
    const Point2 middle{low.x + side / 2, low.y + side / 2};
    const double h = spacing_(patch_.surface(middle));
    const double ratio = side / (0.93 * h);
    const bool is_leaf = ratio < 2 && random_.uniform() * 3 >= ratio * ratio - 1;
    if (is_leaf) {
      const Point2 p{low.x + side * (0.2 + 0.6 * random_.uniform()), low.y + side * (0.2 + 0.6 * random_.uniform())};
      const double distance = std::min(clearance * h, region_.longest_edge());
      if (region_.contains(p) && !region_.is_near_boundary(p, distance)) points_.push_back(p);
      return;
    }
    for (int k = 0; k < 4; ++k) split({low.x + (k & 1) * side / 2, low.y + (k >> 1) * side / 2}, side / 2);
  }

  const Region& region_;
  const Patch& patch_;
  const Spacing& spacing_;
  Random& random_;
  std::vector<Point2> points_;
};

std::uint64_t edge_key(int a, int b) {
  if (a > b) std::swap(a, b);
  return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
}

/// Which triangles lie inside (1) or not (0): going in from outside the hull, each boundary edge that is crossed
/// changes the answer.
std::vector<signed char> inside_triangles(const Triangulation& mesh, std::unordered_set<std::uint64_t> boundary) {
  std::vector<signed char> state(mesh.triangles.size(), -1);
  std::vector<int> queue;
  std::unordered_set<std::uint64_t> found;
  const auto crossing = [&](int t, int k) {
    const std::uint64_t key = edge_key(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
    const bool is_boundary = boundary.count(key) != 0;
    if (is_boundary) found.insert(key);
    return is_boundary;
  };
  for (std::size_t t = 0; t < state.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh.neighbours[t][k] < 0 && state[t] < 0) {
        state[t] = crossing(static_cast<int>(t), k);
        queue.push_back(static_cast<int>(t));
      }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int t = queue[i];
    for (int k = 0; k < 3; ++k) {
      const int other = mesh.neighbours[t][k];
      const bool crosses = crossing(t, k);
      if (other < 0 || state[other] >= 0) continue;
      state[other] = crosses ? !state[t] : state[t];
      queue.push_back(other);
    }
  }
  if (found.size() != boundary.size()) throw std::logic_error("a patch of a generated shape lost a boundary edge");
  return state;
}

}  // namespace

SurfaceBuilder::SurfaceBuilder(Spacing spacing, bool uniform, bool triangulate)
    : spacing_(std::move(spacing)), uniform_(uniform), triangulate_(triangulate) {}

int SurfaceBuilder::add_vertex(const vcg::Point3d& position) {
  vertices_.push_back(position);
  return static_cast<int>(vertices_.size()) - 1;
}

void SurfaceBuilder::add_patch(const Patch& patch) {
  std::vector<std::vector<Point2>> outline;
  std::vector<Point2> points;
  std::vector<int> vertex;
  std::unordered_set<std::uint64_t> boundary;
  for (const auto& loop : patch.loops) {
    auto& places = outline.emplace_back();
    const int first = static_cast<int>(points.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      places.push_back(loop[i].place);
      points.push_back(loop[i].place);
      vertex.push_back(loop[i].vertex);
      boundary.insert(edge_key(first + static_cast<int>(i), first + static_cast<int>((i + 1) % loop.size())));
    }
  }
  const Region region(outline);
  const std::vector<Point2> inner = uniform_ ? scatter_uniform(region, patch.smallest_spacing, random_)
                                             : QuadtreeScatter(region, patch, spacing_, random_).points();
  for (const Point2& p : inner) {
    points.push_back(p);
    vertex.push_back(add_vertex(patch.surface(p)));
  }
  if (!triangulate_) return;
  const Triangulation mesh = delaunay(points);
  const std::vector<signed char> inside = inside_triangles(mesh, std::move(boundary));
  for (std::size_t t = 0; t < inside.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (inside[t]) add_triangle(vertex[a], vertex[b], vertex[c]);
  }
}

void SurfaceBuilder::write_to(Mesh& mesh) const { fill_mesh(vertices_, triangles_, mesh); }

void finish_mesh(Mesh& mesh) {
  vcg::tri::UpdateNormal<Mesh>::PerVertexAngleWeighted(mesh);
  vcg::tri::UpdateNormal<Mesh>::NormalizePerVertex(mesh);
  vcg::tri::UpdateNormal<Mesh>::PerFaceNormalized(mesh);
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
}

void fill_mesh(const std::vector<vcg::Point3d>& vertices, const std::vector<std::array<int, 3>>& triangles,
               Mesh& mesh) {
  mesh.Clear();
  auto vertex = vcg::tri::Allocator<Mesh>::AddVertices(mesh, vertices.size());
  for (const vcg::Point3d& p : vertices) (vertex++)->P() = p;
  auto face = vcg::tri::Allocator<Mesh>::AddFaces(mesh, triangles.size());
  for (const auto& t : triangles) {
    for (int k = 0; k < 3; ++k) face->V(k) = &mesh.vert[t[k]];
    ++face;
  }
  finish_mesh(mesh);
}

}  // namespace mesh_tools::shapes
