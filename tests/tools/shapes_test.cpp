// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/shapes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>
#include <mesh_tools/random.h>
#include <shapes/delaunay.h>

namespace {

using mesh_tools::make_shape;
using mesh_tools::Mesh;

constexpr double pi = 3.14159265358979323846;

/// What can be said of a mesh from its faces alone.
struct Topology {
  std::size_t repeated_sides = 0;  // sides that two faces run through in the same direction
  std::size_t border_edges = 0;
  std::size_t split_vertices = 0;  // vertices whose faces form more than one fan
  std::size_t unused_vertices = 0;
  int euler = 0;
};

Topology topology_of(const Mesh& mesh) {
  Topology topology;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> next;  // (centre, from) -> to, around each vertex
  std::map<std::size_t, std::size_t> degree;
  std::set<std::pair<std::size_t, std::size_t>> sides;
  for (const auto& face : mesh.face) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = vcg::tri::Index(mesh, face.cV(k)), b = vcg::tri::Index(mesh, face.cV((k + 1) % 3));
      const std::size_t c = vcg::tri::Index(mesh, face.cV((k + 2) % 3));
      if (!sides.insert({a, b}).second) ++topology.repeated_sides;
      next[{a, b}] = c;
      ++degree[a];
    }
  }
  std::size_t edges = 0;
  std::map<std::size_t, std::size_t> start;  // where the fan of a border vertex begins
  for (const auto& [a, b] : sides) {
    const bool is_border = sides.count({b, a}) == 0;
    if (is_border) {
      ++topology.border_edges;
      start[a] = b;
    }
    if (is_border || a < b) ++edges;
  }
  for (const auto& [vertex, faces] : degree) {
    const auto at = start.find(vertex);
    const std::size_t first = at != start.end() ? at->second : next.lower_bound({vertex, 0})->first.second;
    std::size_t reached = 0, current = first;
    for (auto step = next.find({vertex, current}); step != next.end() && reached < faces;
         step = next.find({vertex, current})) {
      current = step->second;
      ++reached;
      if (current == first) break;
    }
    if (reached != faces) ++topology.split_vertices;
  }
  topology.unused_vertices = mesh.vert.size() - degree.size();
  topology.euler = mesh.vn - static_cast<int>(edges) + mesh.fn;
  return topology;
}

struct EdgeLengths {
  double shortest = 1e300, longest = 0, mean = 0;
};

EdgeLengths edge_lengths_of(const Mesh& mesh) {
  EdgeLengths lengths;
  for (const auto& face : mesh.face)
    for (int k = 0; k < 3; ++k) {
      const double length = (face.cP(k) - face.cP((k + 1) % 3)).Norm();
      lengths.shortest = std::min(lengths.shortest, length);
      lengths.longest = std::max(lengths.longest, length);
    }
  lengths.mean = mesh_tools::average_edge_length(mesh);
  return lengths;
}

double smallest_angle_in_degrees(const Mesh& mesh) {
  double smallest = 180;
  for (const auto& face : mesh.face)
    for (int k = 0; k < 3; ++k) {
      const vcg::Point3d a = face.cP((k + 1) % 3) - face.cP(k), b = face.cP((k + 2) % 3) - face.cP(k);
      smallest = std::min(smallest, std::atan2((a ^ b).Norm(), a * b) * 180 / pi);
    }
  return smallest;
}

bool is_open(const std::string& name) { return name.rfind("plane_", 0) == 0 || name == "thin_sheets"; }

class EveryShape : public testing::TestWithParam<mesh_tools::Shape> {};

TEST_P(EveryShape, has_about_the_wanted_number_of_vertices) {
  for (const std::size_t wanted : {3000u, 20000u}) {
    const Mesh mesh = make_shape(GetParam().name, wanted);
    EXPECT_NEAR(mesh.vn, static_cast<double>(wanted), 0.05 * static_cast<double>(wanted));
  }
}

TEST_P(EveryShape, is_an_oriented_manifold) {
  const Mesh mesh = make_shape(GetParam().name, 3000);
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(topology.repeated_sides, 0u);
  EXPECT_EQ(topology.split_vertices, 0u);
  EXPECT_EQ(topology.unused_vertices, 0u);
  if (!is_open(GetParam().name)) {
    EXPECT_EQ(topology.border_edges, 0u);
    EXPECT_GT(mesh_tools::signed_volume(mesh), 0);
  } else {
    EXPECT_GT(topology.border_edges, 0u);
  }
}

TEST_P(EveryShape, is_the_same_every_time) {
  const Mesh a = make_shape(GetParam().name, 3000), b = make_shape(GetParam().name, 3000);
  ASSERT_EQ(a.vn, b.vn);
  ASSERT_EQ(a.fn, b.fn);
  for (int i = 0; i < a.vn; ++i) ASSERT_EQ(a.vert[i].cP(), b.vert[i].cP());
  for (int i = 0; i < a.fn; ++i)
    for (int k = 0; k < 3; ++k) ASSERT_EQ(vcg::tri::Index(a, a.face[i].cV(k)), vcg::tri::Index(b, b.face[i].cV(k)));
}

TEST_P(EveryShape, can_be_as_small_as_its_details_allow) {
  const Mesh mesh = make_shape(GetParam().name, 1);
  EXPECT_GE(mesh.vn, 4);
  EXPECT_EQ(topology_of(mesh).split_vertices, 0u);
}

TEST_P(EveryShape, has_no_bad_triangles) {
  const std::string name = GetParam().name;
  if (name == "plane_delaunay") return;  // of uniformly random points: slivers belong to it
  EXPECT_GT(smallest_angle_in_degrees(make_shape(name, 5000)), name == "graded_cube" ? 5 : 15);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(mesh_tools::all_shapes()),
                         [](const auto& shape) { return std::string(shape.param.name); });

TEST(Shapes, have_the_genus_of_their_solid) {
  EXPECT_EQ(topology_of(make_shape("sphere", 3000)).euler, 2);
  EXPECT_EQ(topology_of(make_shape("torus", 3000)).euler, 0);
  EXPECT_EQ(topology_of(make_shape("cube", 3000)).euler, 2);
  EXPECT_EQ(topology_of(make_shape("stepped_block", 3000)).euler, 2);
  EXPECT_EQ(topology_of(make_shape("cad_part", 3000)).euler, 0) << "one hole";
  EXPECT_EQ(topology_of(make_shape("thin_plate", 3000)).euler, 2);
  EXPECT_EQ(topology_of(make_shape("thin_sheets", 3000)).euler, 4) << "four discs";
}

TEST(Shapes, have_the_volume_of_their_solid) {
  EXPECT_NEAR(mesh_tools::signed_volume(make_shape("cube", 3000)), 1, 1e-12);
  EXPECT_NEAR(mesh_tools::signed_volume(make_shape("graded_cube", 3000)), 1, 1e-12);
  EXPECT_NEAR(mesh_tools::signed_volume(make_shape("stepped_block", 3000)), 0.35, 1e-12);
  // Inscribed polyhedra are smaller, by an amount that falls with the square of the edge length.
  EXPECT_NEAR(mesh_tools::signed_volume(make_shape("sphere", 20000)), 4 * pi / 3, 2e-3);
  EXPECT_NEAR(mesh_tools::signed_volume(make_shape("torus", 20000)), 2 * pi * pi * 0.16, 5e-3);
}

/// The fan's volume by midpoint sums over its outlines, without the code that builds it.
TEST(Shapes, cad_part_has_the_volume_of_its_drawing) {
  const auto in_fan = [](double x, double y) {
    const double r = std::hypot(x, y);
    if (x >= 0 && y >= 0) return r > 0.4 && r < 1 && std::hypot(x - 0.5, y - 0.5) > 0.1;
    if (x < -0.35 || x > 0 || y < 0.4 || y > 0.75) return false;
    const bool in_rounded_corner = x < -0.35 + 0.12 && y < 0.4 + 0.12;
    return !in_rounded_corner || std::hypot(x + 0.23, y - 0.52) < 0.12;
  };
  const auto in_sector = [](double x, double y) {
    const double r = std::hypot(x, y), angle = std::atan2(y, x);
    return r > 0.55 && r < 0.87 && angle > pi / 12 && angle < 5 * pi / 12 && std::hypot(x - 0.5, y - 0.5) > 0.1;
  };
  const int n = 1500;
  const double step = 1.4 / n;
  double volume = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = -0.4 + (i + 0.5) * step, y = (j + 0.5) * step;
      if (!in_fan(x, y)) continue;
      const double fall = 1 - 0.35 * (x * x + y * y);
      volume += (in_sector(x, y) ? 0.45 : 0.25) * fall * step * step;
    }
  EXPECT_NEAR(mesh_tools::signed_volume(make_shape("cad_part", 20000)), volume, 0.004 * volume);
}

TEST(Shapes, sphere_and_torus_have_their_vertices_on_the_surface) {
  for (const auto& vertex : make_shape("sphere", 2000).vert) EXPECT_NEAR(vertex.cP().Norm(), 1, 1e-14);
  for (const auto& vertex : make_shape("torus", 2000).vert) {
    const vcg::Point3d& p = vertex.cP();
    EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]), 0.4, 1e-14);
  }
}

/// Every point of every sharp edge of the cube lies on mesh edges: the edges of the mesh along it add up to its length.
TEST(Shapes, cube_edges_are_mesh_edges) {
  for (const char* name : {"cube", "graded_cube"}) {
    const Mesh mesh = make_shape(name, 2000);
    double length = 0;
    const auto sides_of = [](const vcg::Point3d& p) {
      int sides = 0;
      for (int k = 0; k < 3; ++k) sides |= (p[k] == 0 ? 1 << (2 * k) : 0) | (p[k] == 1 ? 2 << (2 * k) : 0);
      return sides;
    };
    const auto count = [](int bits) { return ((bits & 3) != 0) + ((bits & 12) != 0) + ((bits & 48) != 0); };
    for (const auto& face : mesh.face)
      for (int k = 0; k < 3; ++k)
        if (count(sides_of(face.cP(k)) & sides_of(face.cP((k + 1) % 3))) >= 2)
          length += (face.cP(k) - face.cP((k + 1) % 3)).Norm();
    EXPECT_NEAR(length, 2 * 12, 1e-12) << name << ": each of the 12 edges is run through twice";
  }
}

TEST(Shapes, grids_have_the_diagonal_of_their_name) {
  const auto diagonals = [](const char* name) {
    std::pair<int, int> found{0, 0};
    const Mesh mesh = make_shape(name, 100);
    for (const auto& face : mesh.face)
      for (int k = 0; k < 3; ++k) {
        const vcg::Point3d edge = face.cP((k + 1) % 3) - face.cP(k);
        if (edge[0] * edge[1] > 1e-9) ++found.first;
        if (edge[0] * edge[1] < -1e-9) ++found.second;
      }
    return found;
  };
  EXPECT_EQ(diagonals("plane_slash"), std::make_pair(2 * 81, 0));
  EXPECT_EQ(diagonals("plane_backslash"), std::make_pair(0, 2 * 81));
  EXPECT_EQ(diagonals("plane_alternating"), std::make_pair(2 * 41, 2 * 40));
  const auto random = diagonals("plane_random_diagonals");
  EXPECT_GT(random.first, 40);
  EXPECT_GT(random.second, 40);
}

TEST(Shapes, planes_cover_the_unit_square) {
  for (const auto& shape : mesh_tools::all_shapes()) {
    if (std::string(shape.name).rfind("plane_", 0) != 0) continue;
    double area = 0;
    const Mesh mesh = make_shape(shape.name, 2000);
    for (const auto& face : mesh.face) {
      const vcg::Point3d normal = (face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0));
      EXPECT_GT(normal[2], 0) << shape.name;
      area += normal[2] / 2;
    }
    EXPECT_NEAR(area, 1, 1e-12) << shape.name;
  }
}

TEST(Shapes, thin_ones_are_as_thin_as_they_say) {
  const Mesh plate = make_shape("thin_plate", 5000);
  EXPECT_NEAR(plate.bbox.DimZ() / mesh_tools::average_edge_length(plate), 1, 0.1);
  const Mesh sheets = make_shape("thin_sheets", 5000);
  EXPECT_NEAR(sheets.bbox.DimZ() / mesh_tools::average_edge_length(sheets), 3 * 2, 1e-9) << "four sheets, 2 e apart";
  for (const auto& face : sheets.face) EXPECT_GT(((face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0)))[2], 0);
}

TEST(Shapes, graded_cube_grows_tenfold) {
  const Mesh mesh = make_shape("graded_cube", 20000);
  double inside = 0, outside = 0;
  int near_count = 0, far_count = 0;
  for (const auto& face : mesh.face) {
    const vcg::Point3d centre = (face.cP(0) + face.cP(1) + face.cP(2)) / 3;
    for (int k = 0; k < 3; ++k) {
      const double length = (face.cP(k) - face.cP((k + 1) % 3)).Norm();
      if (centre.Norm() < 0.1) inside += length, ++near_count;
      if (centre.Norm() > 1.55) outside += length, ++far_count;
    }
  }
  ASSERT_GT(far_count, 0);
  // Near the far corner the spacing is 9.3 to 10 times that of the near one, where it has grown by up to 1.5 already.
  const double ratio = outside / far_count / (inside / near_count);
  EXPECT_GT(ratio, 6);
  EXPECT_LT(ratio, 10);
  const EdgeLengths lengths = edge_lengths_of(mesh);
  EXPECT_GT(lengths.longest / lengths.shortest, 10);
}

TEST(Shapes, names_take_dashes_too_and_unknown_ones_are_refused) {
  EXPECT_EQ(make_shape("plane-slash", 100).vn, 100);
  try {
    make_shape("dodecahedron", 100);
    FAIL() << "must throw";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'dodecahedron'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("stepped_block"), std::string::npos);
  }
}

/// No point lies inside a circumcircle: checked for all pairs on points with many cocircular ones, in exact integers.
TEST(Delaunay, circumcircles_are_empty) {
  using mesh_tools::shapes::Point2;
  mesh_tools::Random random(7);
  std::set<std::pair<int, int>> places;
  while (places.size() < 300)
    places.insert({static_cast<int>(40 * random.uniform()), static_cast<int>(40 * random.uniform())});
  std::vector<Point2> points;
  for (const auto& [x, y] : places) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  const auto mesh = mesh_tools::shapes::delaunay(points);
  for (const auto& t : mesh.triangles) {
    const Point2 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    ASSERT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0) << "counter-clockwise";
    for (const Point2& d : points) {
      const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
      const double det = (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
                         (cx * cx + cy * cy) * (ax * by - ay * bx);
      ASSERT_LE(det, 0);
    }
  }
}

TEST(Delaunay, covers_the_convex_hull) {
  using mesh_tools::shapes::Point2;
  std::vector<Point2> points;  // a grid: all cocircular, all hull edges cut by points
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 20; ++j) points.push_back({static_cast<double>(i), static_cast<double>(j)});
  const auto mesh = mesh_tools::shapes::delaunay(points);
  EXPECT_EQ(mesh.triangles.size(), 2u * 29 * 19);
  int hull_edges = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int other = mesh.neighbours[t][k];
      if (other < 0) {
        ++hull_edges;
        continue;
      }
      const auto& v = mesh.triangles[other];
      EXPECT_NE(std::find(v.begin(), v.end(), mesh.triangles[t][(k + 1) % 3]), v.end());
      EXPECT_NE(std::find(v.begin(), v.end(), mesh.triangles[t][(k + 2) % 3]), v.end());
    }
  EXPECT_EQ(hull_edges, 2 * (29 + 19));
}

TEST(Delaunay, refuses_what_has_no_triangulation) {
  using mesh_tools::shapes::delaunay;
  EXPECT_THROW(delaunay({{0, 0}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(delaunay({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), std::invalid_argument);
  EXPECT_THROW(delaunay({{0, 0}, {1, 0}, {0, 1}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(delaunay({{1, 1}, {1, 1}, {1, 1}}), std::invalid_argument);
}

}  // namespace
