// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace mesh_tools::shapes {
namespace {

__extension__ using Wide = __int128;

constexpr int ghost = -1;  // the vertex at infinity: every edge of the hull carries a triangle with it

int next(int k) { return k == 2 ? 0 : k + 1; }
int previous(int k) { return k == 0 ? 2 : k - 1; }

std::uint64_t scrambled(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

std::uint64_t spread_bits(std::uint64_t value) {
  value = (value | (value << 16)) & 0x0000ffff0000ffffu;
  value = (value | (value << 8)) & 0x00ff00ff00ff00ffu;
  value = (value | (value << 4)) & 0x0f0f0f0f0f0f0f0fu;
  value = (value | (value << 2)) & 0x3333333333333333u;
  return (value | (value << 1)) & 0x5555555555555555u;
}

class Builder {
 public:
  explicit Builder(const std::vector<Point2>& points) { snap(points); }

  Triangulation build() {
    const std::vector<int> order = insertion_order();
    const std::size_t third = start(order);
    for (std::size_t i = 2; i < order.size(); ++i)
      if (i != third) insert(order[i]);
    return extract();
  }

 private:
  struct Grid {
    std::int64_t x, y;
  };
  struct CavityEdge {
    int from, to, outside;
  };

  void snap(const std::vector<Point2>& points) {
    if (points.size() < 3) throw std::invalid_argument("a Delaunay triangulation needs at least three points");
    Point2 low = points.front(), high = low;
    for (const Point2& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double extent = std::max(high.x - low.x, high.y - low.y);
    if (!(extent > 0) || !std::isfinite(extent)) throw std::invalid_argument("the points have no finite extent");
    int exponent = 0;
    std::frexp(extent, &exponent);
    grid_.reserve(points.size());
    for (const Point2& p : points)  // a power of two: points that lie on such a grid are not moved
      grid_.push_back(
          {std::llround(std::ldexp(p.x - low.x, 30 - exponent)), std::llround(std::ldexp(p.y - low.y, 30 - exponent))});
    link_.assign(points.size() + 1, -1);
  }

  /// Random rounds of doubling size, each along a space-filling curve: short walks, and no bad case.
  std::vector<int> insertion_order() const {
    std::vector<std::pair<std::uint64_t, int>> keys(grid_.size());
    for (std::size_t i = 0; i < grid_.size(); ++i) {
      std::uint64_t round = 0;
      for (std::uint64_t bits = scrambled(i); (bits & 1) && round < 15; bits >>= 1) ++round;
      const std::uint64_t curve = spread_bits(static_cast<std::uint64_t>(grid_[i].x) >> 2) |
                                  (spread_bits(static_cast<std::uint64_t>(grid_[i].y) >> 2) << 1);
      keys[i] = {((15 - round) << 60) | curve, static_cast<int>(i)};
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> order(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
    return order;
  }

  std::int64_t orientation(int a, int b, int c) const {
    const Grid &p = grid_[a], &q = grid_[b], &r = grid_[c];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }

  bool in_circle(int a, int b, int c, int d) const {
    const Grid& o = grid_[d];
    const std::int64_t ax = grid_[a].x - o.x, ay = grid_[a].y - o.y;
    const std::int64_t bx = grid_[b].x - o.x, by = grid_[b].y - o.y;
    const std::int64_t cx = grid_[c].x - o.x, cy = grid_[c].y - o.y;
    return Wide(ax * ax + ay * ay) * (bx * cy - by * cx) + Wide(bx * bx + by * by) * (cx * ay - cy * ax) +
               Wide(cx * cx + cy * cy) * (ax * by - ay * bx) >
           0;
  }

  bool strictly_between(int a, int b, int p) const {
    const Grid &u = grid_[a], &v = grid_[b], &w = grid_[p];
    return (u.x - w.x) * (v.x - w.x) + (u.y - w.y) * (v.y - w.y) < 0;
  }

  bool in_conflict(int t, int p) const {
    const auto& v = vertex_[t];
    for (int k = 0; k < 3; ++k) {
      if (v[k] != ghost) continue;
      const int a = v[next(k)], b = v[previous(k)];
      const std::int64_t side = orientation(a, b, p);
      return side > 0 || (side == 0 && strictly_between(a, b, p));
    }
    return in_circle(v[0], v[1], v[2], p);
  }

  std::size_t start(const std::vector<int>& order) {
    const int a = order[0], b = order[1];
    std::size_t third = 2;
    while (third < order.size() && orientation(a, b, order[third]) == 0) ++third;
    if (third == order.size()) throw std::invalid_argument("all points lie on a line");
    const int c = order[third];
    const bool left = orientation(a, b, c) > 0;
    const int p = left ? a : b, q = left ? b : a;
    vertex_ = {{p, q, c}, {ghost, c, q}, {ghost, p, c}, {ghost, q, p}};
    neighbour_ = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    stamp_.assign(4, 0);
    last_ = 0;
    return third;
  }

  int locate(int p) const {
    int t = last_;
    for (int k = 0; k < 3; ++k)
      if (vertex_[t][k] == ghost) {
        t = neighbour_[t][k];
        break;
      }
    for (;;) {
      int step = -1;
      for (int k = 0; k < 3 && step < 0; ++k)
        if (orientation(vertex_[t][next(k)], vertex_[t][previous(k)], p) < 0) step = k;
      if (step < 0) return t;
      t = neighbour_[t][step];
      for (int v : vertex_[t])
        if (v == ghost) return t;
    }
  }

  void insert(int p) {
    const int first = locate(p);
    for (int v : vertex_[first])
      if (v != ghost && grid_[v].x == grid_[p].x && grid_[v].y == grid_[p].y)
        throw std::invalid_argument("two points of a Delaunay triangulation coincide");
    ++current_stamp_;
    cavity_.assign(1, first);
    rim_.clear();
    stamp_[first] = current_stamp_;
    for (std::size_t i = 0; i < cavity_.size(); ++i) {
      const int t = cavity_[i];
      for (int k = 0; k < 3; ++k) {
        const int other = neighbour_[t][k];
        if (stamp_[other] == current_stamp_) continue;
        if (in_conflict(other, p)) {
          stamp_[other] = current_stamp_;
          cavity_.push_back(other);
        } else {
          rim_.push_back({vertex_[t][next(k)], vertex_[t][previous(k)], other});
        }
      }
    }
    fill_cavity(p);
  }

  /// Replaces the cavity's triangles by the fan from p to its rim; the fan has two triangles more.
  void fill_cavity(int p) {
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      int t;
      if (i < cavity_.size()) {
        t = cavity_[i];
      } else {
        t = static_cast<int>(vertex_.size());
        vertex_.emplace_back();
        neighbour_.emplace_back();
        stamp_.push_back(0);
      }
      const CavityEdge& edge = rim_[i];
      vertex_[t] = {edge.from, edge.to, p};
      neighbour_[t][2] = edge.outside;
      const auto& beyond = vertex_[edge.outside];
      for (int k = 0; k < 3; ++k)
        if (beyond[next(k)] == edge.to && beyond[previous(k)] == edge.from) neighbour_[edge.outside][k] = t;
      link_[edge.from + 1] = t;
      last_ = t;
    }
    for (const CavityEdge& edge : rim_) {
      const int t = link_[edge.from + 1], after = link_[edge.to + 1];
      neighbour_[t][0] = after;
      neighbour_[after][1] = t;
    }
  }

  Triangulation extract() const {
    std::vector<int> number(vertex_.size(), -1);
    Triangulation result;
    for (std::size_t t = 0; t < vertex_.size(); ++t) {
      const auto& v = vertex_[t];
      if (v[0] == ghost || v[1] == ghost || v[2] == ghost) continue;
      number[t] = static_cast<int>(result.triangles.size());
      result.triangles.push_back(v);
    }
    result.neighbours.reserve(result.triangles.size());
    for (std::size_t t = 0; t < vertex_.size(); ++t) {
      if (number[t] < 0) continue;
      const auto& n = neighbour_[t];
      result.neighbours.push_back({number[n[0]], number[n[1]], number[n[2]]});
    }
    return result;
  }

  std::vector<Grid> grid_;
  std::vector<std::array<int, 3>> vertex_, neighbour_;
  std::vector<int> stamp_;
  std::vector<int> link_;  // link_[v + 1]: the new triangle whose rim edge starts at v
  std::vector<int> cavity_;
  std::vector<CavityEdge> rim_;
  int current_stamp_ = 0;
  int last_ = 0;
};

}  // namespace

Triangulation delaunay(const std::vector<Point2>& points) { return Builder(points).build(); }

}  // namespace mesh_tools::shapes
