// SPDX-License-Identifier: GPL-3.0-or-later
// Solids of flat and cylindrical faces, built by extrusion.

#include <cmath>
#include <functional>
#include <vector>

#include <vcg/complex/algorithms/update/bounding.h>

#include "extrusion.h"
#include "families.h"
#include "patch.h"

namespace mesh_tools::shapes {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Builds with the edge length that gives the wanted number of vertices: first guess from the area, then corrected
/// by trial without triangulation.
void build_with_count(std::size_t vertices, double area, Mesh& mesh,
                      const std::function<SurfaceBuilder(double h, bool triangulate)>& build) {
  const double wanted = static_cast<double>(vertices);
  double h = std::sqrt(area / (std::sqrt(0.75) * wanted)), best = h, smallest_error = INFINITY;
  for (int trial = 0; trial < 8; ++trial) {
    const double ratio = static_cast<double>(build(h, false).vertex_count()) / wanted;
    const double error = std::abs(ratio - 1);
    if (error < smallest_error) {
      smallest_error = error;
      best = h;
    }
    if (error < 0.005) break;
    h *= std::sqrt(ratio);
  }
  build(best, true).write_to(mesh);
}

Spacing constant(double h) {
  return [h](const vcg::Point3d&) { return h; };
}

/// Solid between heights 0 and `height` over an outline.
void extrude(SurfaceBuilder& builder, const Outline& outline, double height, double h) {
  const Ring bottom = add_ring(builder, outline, 0), top = add_ring(builder, outline, height);
  add_cap(builder, {&bottom}, Facing::down, h);
  add_wall(builder, bottom, top, h);
  add_cap(builder, {&top}, Facing::up, h);
}

const std::vector<Point2> unit_square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// A quarter of a ring with a tab: sharp corners, fillets inside and outside, a convex and a concave cylinder.
Outline fan_outline() {
  Outline outline({0.4, 0});
  outline.line_to({1, 0});
  outline.corner();
  outline.arc({0, 0}, pi / 2);
  outline.corner();
  outline.rounded_line_to({0, 0.75}, {-0.35, 0.75}, 0.1);
  outline.line_to({-0.35, 0.75});
  outline.corner();
  outline.rounded_line_to({-0.35, 0.4}, {0, 0.4}, 0.12);
  outline.line_to({0, 0.4});
  outline.arc({0, 0}, -pi / 2);
  outline.corner();
  return outline;
}

/// The raised sector on the fan.
Outline sector_outline() {
  const double first = pi / 12, last = 5 * pi / 12, inner = 0.55, outer = 0.87;
  Outline outline({inner * std::cos(first), inner * std::sin(first)});
  outline.line_to({outer * std::cos(first), outer * std::sin(first)});
  outline.corner();
  outline.arc({0, 0}, last - first);
  outline.corner();
  outline.line_to({inner * std::cos(last), inner * std::sin(last)});
  outline.corner();
  outline.arc({0, 0}, first - last);
  outline.corner();
  return outline;
}

}  // namespace

void make_cube(std::size_t vertices, Mesh& mesh) {
  const Outline outline = Outline::polygon(unit_square);
  build_with_count(vertices, 6, mesh, [&](double h, bool triangulate) {
    SurfaceBuilder builder(constant(h), true, triangulate);
    extrude(builder, outline, 1, h);
    return builder;
  });
}

void make_stepped_block(std::size_t vertices, Mesh& mesh) {
  const Outline outline = Outline::polygon(
      {{0, 0}, {1, 0}, {1, 0.2}, {0.75, 0.2}, {0.75, 0.4}, {0.5, 0.4}, {0.5, 0.6}, {0.25, 0.6}, {0.25, 0.8}, {0, 0.8}});
  build_with_count(vertices, 2 * 0.5 + 3.6 * 0.7, mesh, [&](double h, bool triangulate) {
    SurfaceBuilder builder(constant(h), true, triangulate);
    extrude(builder, outline, 0.7, h);
    return builder;
  });
}

void make_cad_part(std::size_t vertices, Mesh& mesh) {
  constexpr double middle = 0.25, height = 0.45;
  const Outline fan = fan_outline(), sector = sector_outline();
  const Outline hole = Outline::circular_hole({0.5, 0.5}, 0.1);
  build_with_count(vertices, 3.3, mesh, [&](double h, bool triangulate) {
    SurfaceBuilder builder(constant(h), true, triangulate);
    const Ring fan_low = add_ring(builder, fan, 0), fan_high = add_ring(builder, fan, middle);
    const Ring sector_low = add_ring(builder, sector, middle), sector_high = add_ring(builder, sector, height);
    const Ring hole_low = add_ring(builder, hole, 0), hole_high = add_ring(builder, hole, height);
    add_cap(builder, {&fan_low, &hole_low}, Facing::down, h);
    add_wall(builder, fan_low, fan_high, h);
    add_cap(builder, {&fan_high, &sector_low}, Facing::up, h);
    add_wall(builder, sector_low, sector_high, h);
    add_cap(builder, {&sector_high, &hole_high}, Facing::up, h);
    add_wall(builder, hole_low, hole_high, h);
    // The upper faces fall off outwards, so that the sharp edges around them are curved in space.
    for (vcg::Point3d& p : builder.vertices()) p.Z() *= 1 - 0.35 * (p.X() * p.X() + p.Y() * p.Y());
    return builder;
  });
}

void make_thin_plate(std::size_t vertices, Mesh& mesh) {
  const Outline outline = Outline::polygon(unit_square);
  build_with_count(vertices, 2, mesh, [&](double h, bool triangulate) {
    SurfaceBuilder builder(constant(h), true, triangulate);
    extrude(builder, outline, h, h);
    return builder;
  });
}

void make_thin_sheets(std::size_t vertices, Mesh& mesh) {
  constexpr int sheets = 4;
  const Outline outline = Outline::polygon(unit_square);
  build_with_count(vertices, sheets, mesh, [&](double h, bool triangulate) {
    SurfaceBuilder builder(constant(h), true, triangulate);
    for (int k = 0; k < sheets; ++k) {
      const Ring border = add_ring(builder, outline, k);
      add_cap(builder, {&border}, Facing::up, h);
    }
    return builder;
  });
  const double distance = 2 * average_edge_length(mesh);  // within the sheets: no edge joins two of them
  for (auto& vertex : mesh.vert) vertex.P().Z() *= distance;
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
}

void make_graded_cube(std::size_t vertices, Mesh& mesh) {
  const Outline outline = Outline::polygon(unit_square);
  build_with_count(vertices, 6, mesh, [&](double h, bool triangulate) {
    const double smallest = h / 4;
    const auto spacing = [smallest](const vcg::Point3d& p) { return smallest * (1 + 9 * p.Norm() / std::sqrt(3.0)); };
    SurfaceBuilder builder(spacing, false, triangulate);
    extrude(builder, outline, 1, smallest);
    return builder;
  });
}

}  // namespace mesh_tools::shapes
