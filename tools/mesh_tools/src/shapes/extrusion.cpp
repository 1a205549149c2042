// SPDX-License-Identifier: GPL-3.0-or-later
#include "extrusion.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace mesh_tools::shapes {
namespace {

/// Cuts a curve of `length` into edges of about the wanted length: the places of the cuts, without the two ends.
std::vector<double> cuts(double length, const std::function<double(double)>& spacing_at, int at_least) {
  constexpr int steps = 256;
  std::vector<double> edges_up_to(steps + 1, 0.0);  // number of edges from the start, a running integral of 1/spacing
  for (int i = 0; i < steps; ++i)
    edges_up_to[i + 1] = edges_up_to[i] + length / steps / spacing_at((i + 0.5) / steps * length);
  const int count = std::max(at_least, static_cast<int>(std::lround(edges_up_to.back())));
  std::vector<double> places;
  int i = 0;
  for (int k = 1; k < count; ++k) {
    const double wanted = edges_up_to.back() * k / count;
    while (i + 1 < steps && edges_up_to[i + 1] < wanted) ++i;
    const double part = (wanted - edges_up_to[i]) / (edges_up_to[i + 1] - edges_up_to[i]);
    places.push_back((i + part) / steps * length);
  }
  return places;
}

/// The vertical edge above a point, from the lower vertex to the upper one, both included.
struct Seam {
  std::vector<int> vertices;
};

Seam add_seam(SurfaceBuilder& builder, int lower, int upper) {
  const vcg::Point3d from = builder.position(lower), to = builder.position(upper);
  const double length = (to - from).Norm();
  Seam seam{{lower}};
  for (double s : cuts(
           length, [&](double t) { return builder.spacing(from + (to - from) * (t / length)); }, 1))
    seam.vertices.push_back(builder.add_vertex(from + (to - from) * (s / length)));
  seam.vertices.push_back(upper);
  return seam;
}

void append_seam(const SurfaceBuilder& builder, const Seam& seam, double u, std::vector<Corner>& loop) {
  for (int vertex : seam.vertices) loop.push_back({vertex, {u, builder.position(vertex).Z()}});
  loop.pop_back();
}

}  // namespace

Ring add_ring(SurfaceBuilder& builder, const Outline& outline, double height) {
  Ring ring{&outline, height, {}};
  const auto place = [&](std::size_t run, double s) {
    const Point2 p = outline.at(run, s);
    return vcg::Point3d(p.x, p.y, height);
  };
  const std::size_t runs = outline.run_count();
  for (std::size_t run = 0; run < runs; ++run) {
    const double length = outline.run_length(run);
    auto& samples = ring.runs.emplace_back();
    samples.push_back({builder.add_vertex(place(run, 0)), 0});
    const int at_least = runs == 1 ? 3 : 1;
    for (double s : cuts(
             length, [&](double t) { return builder.spacing(place(run, t)); }, at_least))
      samples.push_back({builder.add_vertex(place(run, s)), s});
  }
  for (std::size_t run = 0; run < runs; ++run)
    ring.runs[run].push_back({ring.runs[(run + 1) % runs].front().vertex, outline.run_length(run)});
  return ring;
}

void add_wall(SurfaceBuilder& builder, const Ring& lower, const Ring& upper, double smallest_spacing) {
  const Outline& outline = *lower.outline;
  const std::size_t runs = outline.run_count();
  std::vector<Seam> seams;
  for (std::size_t run = 0; run < runs; ++run)
    seams.push_back(add_seam(builder, lower.runs[run].front().vertex, upper.runs[run].front().vertex));
  for (std::size_t run = 0; run < runs; ++run) {
    const auto &below = lower.runs[run], &above = upper.runs[run];
    const double length = outline.run_length(run);
    std::vector<Corner> loop;
    for (std::size_t i = 0; i + 1 < below.size(); ++i)
      loop.push_back({below[i].vertex, {below[i].length, lower.height}});
    append_seam(builder, seams[(run + 1) % runs], length, loop);
    for (std::size_t i = above.size() - 1; i > 0; --i)
      loop.push_back({above[i].vertex, {above[i].length, upper.height}});
    Seam down = seams[run];
    std::reverse(down.vertices.begin(), down.vertices.end());
    append_seam(builder, down, 0, loop);
    const auto surface = [&outline, run](const Point2& p) {
      const Point2 q = outline.at(run, p.x);
      return vcg::Point3d(q.x, q.y, p.y);
    };
    builder.add_patch({{loop}, surface, smallest_spacing});
  }
}

void add_cap(SurfaceBuilder& builder, const std::vector<const Ring*>& rings, Facing facing, double smallest_spacing) {
  Patch patch;
  const double height = rings.front()->height;
  const bool up = facing == Facing::up;
  for (const Ring* ring : rings) {
    auto& loop = patch.loops.emplace_back();
    for (const auto& run : ring->runs) {
      for (std::size_t i = 0; i + 1 < run.size(); ++i) {
        const vcg::Point3d& p = builder.position(run[i].vertex);
        loop.push_back({run[i].vertex, up ? Point2{p.X(), p.Y()} : Point2{p.Y(), p.X()}});
      }
    }
  }
  patch.surface = [height, up](const Point2& p) {
    return up ? vcg::Point3d(p.x, p.y, height) : vcg::Point3d(p.y, p.x, height);
  };
  patch.smallest_spacing = smallest_spacing;
  builder.add_patch(patch);
}

}  // namespace mesh_tools::shapes
