// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/clean_shapes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <support/hand_made.h>

namespace test_support {

namespace {

const double pi = std::acos(-1.0);

Point at_angle(double radius, double angle, double height = 0) {
  return Point(radius * std::cos(angle), radius * std::sin(angle), height);
}

/// Alternating teeth of one side each: every vertex is a corner.
std::vector<Point> gear(std::size_t teeth, double depth) {
  std::vector<Point> outline;
  for (std::size_t k = 0; k < 2 * teeth; ++k)
    outline.push_back(at_angle(k % 2 == 0 ? 1 : 1 - depth, pi * static_cast<double>(k) / static_cast<double>(teeth)));
  return outline;
}

/// Square teeth: two corners out, two in.
std::vector<Point> square_gear(std::size_t teeth, double depth) {
  std::vector<Point> outline;
  for (std::size_t k = 0; k < 4 * teeth; ++k)
    outline.push_back(at_angle(k % 4 < 2 ? 1 : 1 - depth,
                               pi * (2.0 * static_cast<double>(k) + 1) / (4.0 * static_cast<double>(teeth))));
  return outline;
}

/// Profile of a rod with a thread of triangular section: radii alternate from row to row.
std::vector<std::pair<double, double>> thread(std::size_t rows, double depth, double pitch) {
  std::vector<std::pair<double, double>> profile;
  for (std::size_t k = 0; k < rows; ++k)
    profile.emplace_back(k % 2 == 0 ? 1 : 1 - depth, 0.5 * pitch * static_cast<double>(k));
  return profile;
}

std::vector<std::pair<double, double>> figurine() {
  return {{0.5, 0},   {0.55, 0.1}, {0.2, 0.25}, {0.25, 0.8}, {0.5, 1.1},  {0.45, 1.5},
          {0.2, 1.7}, {0.17, 1.8}, {0.3, 1.95}, {0.33, 2.2}, {0.15, 2.45}};
}

/// A ball with lumps about as long as two of its edges: a head as games have it.
FlatMesh low_polygon_head(int levels) {
  return transformed(icosphere(levels), [](const Point& p) {
    const double lump =
        0.12 * std::sin(3.1 * p[0] + 1) * std::sin(2.7 * p[1] + 2) + 0.1 * std::sin(4.3 * p[2] + 0.5) * p[0];
    const double nose = 0.5 * std::exp(-12 * ((p[0] - 1) * (p[0] - 1) + p[1] * p[1] + p[2] * p[2]));
    return Point(p * (1 + lump + nose));
  });
}

FlatMesh box_of_strips(std::size_t strips) {
  std::vector<Point> outline;
  for (std::size_t k = 0; k <= strips; ++k) outline.emplace_back(static_cast<double>(k), 0, 0);
  for (std::size_t k = strips + 1; k-- > 0;) outline.emplace_back(static_cast<double>(k), 8, 0);
  return prism(outline, false);
}

}  // namespace

FlatMesh split_in_four(const FlatMesh& mesh) {
  FlatMesh split;
  split.points = mesh.points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle;
  const auto between = [&](std::size_t a, std::size_t b) {
    const auto found = middle.emplace(std::minmax(a, b), split.points.size());
    if (found.second) split.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
    return found.first->second;
  };
  for (const Triangle& f : mesh.faces) {
    const std::size_t a = between(f[0], f[1]), b = between(f[1], f[2]), c = between(f[2], f[0]);
    for (const Triangle& part : {Triangle{f[0], a, c}, Triangle{f[1], b, a}, Triangle{f[2], c, b}, Triangle{a, b, c}})
      split.faces.push_back(part);
  }
  return split;
}

FlatMesh prism(const std::vector<Point>& outline, bool fan) {
  const std::size_t n = outline.size();
  FlatMesh mesh;
  for (const double height : {0.0, 1.0})
    for (const Point& p : outline) mesh.points.emplace_back(p[0], p[1], height);
  if (fan)
    for (const double height : {0.0, 1.0}) mesh.points.emplace_back(0, 0, height);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    mesh.faces.push_back({k, next, n + next});
    mesh.faces.push_back({k, n + next, n + k});
    if (fan) {
      mesh.faces.push_back({2 * n, next, k});
      mesh.faces.push_back({2 * n + 1, n + k, n + next});
    } else if (k > 0 && next > 0) {
      mesh.faces.push_back({0, next, k});
      mesh.faces.push_back({n, n + k, n + next});
    }
  }
  return mesh;
}

std::vector<Point> polygon(std::size_t sides) {
  std::vector<Point> outline;
  for (std::size_t k = 0; k < sides; ++k)
    outline.push_back(at_angle(1, 2 * pi * static_cast<double>(k) / static_cast<double>(sides)));
  return outline;
}

FlatMesh cone(std::size_t sides) {
  FlatMesh mesh;
  mesh.points = polygon(sides);
  mesh.points.emplace_back(0, 0, 0);
  mesh.points.emplace_back(0, 0, 2);
  for (std::size_t k = 0; k < sides; ++k) {
    const std::size_t next = (k + 1) % sides;
    mesh.faces.push_back({sides, next, k});
    mesh.faces.push_back({sides + 1, k, next});
  }
  return mesh;
}

FlatMesh plate_with_fine_hole(std::size_t sides, std::size_t rows) {
  FlatMesh mesh;
  for (std::size_t row = 0; row <= rows; ++row)
    for (const Point& p : polygon(sides))
      mesh.points.emplace_back(p[0], p[1], static_cast<double>(row) / static_cast<double>(rows));
  const auto at = [&](std::size_t row, std::size_t k) { return row * sides + k % sides; };
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t k = 0; k < sides; ++k) {
      mesh.faces.push_back({at(row, k), at(row + 1, k + 1), at(row, k + 1)});
      mesh.faces.push_back({at(row, k), at(row + 1, k), at(row + 1, k + 1)});
    }
  const std::size_t corner = mesh.points.size();
  for (const double height : {0.0, 1.0})
    for (const double angle : {0.25, 0.75, 1.25, 1.75})
      mesh.points.push_back(at_angle(5 * std::sqrt(2.0), angle * pi, height));
  const auto cap = [&](std::size_t side, std::size_t a, std::size_t b, std::size_t c) {
    mesh.faces.push_back(side == 1 ? Triangle{a, b, c} : Triangle{c, b, a});
  };
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      const std::size_t here = corner + 4 * side + quarter, next = corner + 4 * side + (quarter + 1) % 4;
      for (std::size_t k = quarter * sides / 4; k < (quarter + 1) * sides / 4; ++k)
        cap(side, here, at(side * rows, k + 1), at(side * rows, k));
      cap(side, here, next, at(side * rows, (quarter + 1) * sides / 4));
      if (side == 0) {
        mesh.faces.push_back({here, next, next + 4});
        mesh.faces.push_back({here, next + 4, here + 4});
      }
    }
  return mesh;
}

FlatMesh lathe(const std::vector<std::pair<double, double>>& profile, std::size_t sides) {
  FlatMesh mesh;
  const std::size_t rings = profile.size();
  for (const auto& [radius, height] : profile)
    for (std::size_t k = 0; k < sides; ++k)
      mesh.points.push_back(at_angle(radius, 2 * pi * static_cast<double>(k) / static_cast<double>(sides), height));
  mesh.points.emplace_back(0, 0, profile.front().second);
  mesh.points.emplace_back(0, 0, profile.back().second);
  for (std::size_t k = 0; k < sides; ++k) {
    const std::size_t next = (k + 1) % sides;
    for (std::size_t ring = 0; ring + 1 < rings; ++ring) {
      const std::size_t below = ring * sides, above = below + sides;
      mesh.faces.push_back({below + k, below + next, above + next});
      mesh.faces.push_back({below + k, above + next, above + k});
    }
    mesh.faces.push_back({rings * sides, next, k});
    mesh.faces.push_back({rings * sides + 1, (rings - 1) * sides + k, (rings - 1) * sides + next});
  }
  return mesh;
}

std::vector<CleanShape> clean_shapes() {
  std::vector<CleanShape> shapes = {
      {"cube of 12 triangles", cube()},
      {"octahedron", octahedron()},
      {"icosahedron", icosphere(0)},
      {"sphere of 162", icosphere(2)},
      {"plate with fine hole", plate_with_fine_hole(256, 64)},
      {"gear", prism(gear(40, 0.1), true)},
      {"fine gear", prism(gear(300, 0.02), true)},
      {"gear of square teeth", prism(square_gear(30, 0.15), true)},
      {"thread", lathe(thread(61, 0.15, 0.2), 32)},
      {"fine thread", lathe(thread(200, 0.05, 0.1), 64)},
      {"figurine of 8 sides", lathe(figurine(), 8)},
      {"figurine of 40 sides", lathe(figurine(), 40)},
      {"low polygon head", low_polygon_head(2)},
      {"finer head", low_polygon_head(3)},
      {"box of strips", box_of_strips(100)},
      {"waves", height_field(40, [](double x, double y) { return 0.1 * std::sin(9 * x) * std::cos(7 * y); })},
      {"terraces", height_field(40, [](double x, double y) { return 0.1 * std::floor(4 * x + 2 * y); })},
      {"tent", height_field(31, [](double x, double y) { return 1 - std::abs(x - 0.5) - std::abs(y - 0.5); })},
  };
  for (const std::size_t sides : {3, 4, 5, 6, 8, 12, 32, 128, 512}) {
    const std::string of = " of " + std::to_string(sides) + " sides";
    shapes.push_back({"prism" + of, prism(polygon(sides), true)});
    shapes.push_back({"ear-clipped prism" + of, prism(polygon(sides), false)});
    shapes.push_back({"cone" + of, cone(sides)});
    shapes.push_back({"cylinder" + of, lathe({{1, 0}, {1, 0.1}, {1, 0.2}, {1, 0.4}, {1, 0.8}, {1, 1.6}}, sides)});
  }
  const std::size_t count = shapes.size();
  for (std::size_t k = 0; k < count; ++k)
    shapes.push_back({shapes[k].name + ", split in four", split_in_four(shapes[k].mesh)});
  return shapes;
}

}  // namespace test_support
