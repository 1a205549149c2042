// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/bad_meshes.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <support/hand_made.h>
#include <support/high_valence.h>

namespace test_support {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A bumpy sheet with a border; most families are made of one.
FlatMesh sheet(std::size_t side = 7) {
  return height_field(side, [](double x, double y) { return 0.1 * std::sin(9 * x + 1) * std::cos(7 * y); });
}

FlatMesh scaled(const FlatMesh& mesh, double factor) {
  return transformed(mesh, [&](const Point& p) { return p * factor; });
}

/// `count` triangles around vertex 0 in a row, as a hand of cards; `angle` between the first and the last edge.
FlatMesh fan(std::size_t count, double angle) {
  FlatMesh mesh{{{0, 0, 0.3}}, {}};
  for (std::size_t k = 0; k <= count; ++k) {
    const double phi = angle * static_cast<double>(k) / static_cast<double>(count);
    mesh.points.emplace_back(std::cos(phi), std::sin(phi), 0.02 * static_cast<double>(k % 3));
  }
  for (std::size_t k = 1; k <= count; ++k) mesh.faces.push_back({0, k, k + 1});
  return mesh;
}

/// Two fans that share nothing but their hub.
FlatMesh bow_tie() {
  FlatMesh mesh = fan(5, 2);
  const std::size_t offset = mesh.points.size() - 1;
  for (const Triangle& f : fan(5, 2).faces) mesh.faces.push_back({0, f[1] + offset, f[2] + offset});
  for (std::size_t v = 1; v <= offset; ++v) mesh.points.push_back(-mesh.points[v]);
  return mesh;
}

/// A fan that closes: a cone whose apex has `count` neighbours.
FlatMesh cone(std::size_t count) {
  FlatMesh mesh = fan(count, 2 * pi);
  mesh.points.pop_back();
  mesh.faces.back()[2] = 1;
  return mesh;
}

/// As many leaves on one edge.
FlatMesh book(std::size_t leaves) {
  FlatMesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}};
  for (std::size_t k = 0; k < leaves; ++k) {
    const double phi = 2 * pi * static_cast<double>(k) / static_cast<double>(leaves);
    mesh.points.emplace_back(std::cos(phi), std::sin(phi), 0.4);
    mesh.faces.push_back({0, 1, k + 2});
  }
  return mesh;
}

/// A grid of quads whose last row is joined to its first; its vertices lie at place(u, v) for u, v in [0, 1].
/// `twisted`: joined upside down.
template <class Place>
FlatMesh band(std::size_t around, std::size_t across, bool closed_across, bool twisted, const Place& place) {
  FlatMesh mesh;
  const std::size_t rows = closed_across ? across : across + 1;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < rows; ++j)
      mesh.points.push_back(place(static_cast<double>(i) / static_cast<double>(around),
                                  static_cast<double>(j) / static_cast<double>(across)));
  const auto at = [&](std::size_t i, std::size_t j) {
    if (closed_across) j %= across;
    if (i == around && twisted) j = (across - j) % rows;
    return i % around * rows + j;
  };
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

FlatMesh moebius_strip() {
  return band(24, 3, false, true, [](double u, double v) {
    const double half = pi * u;
    const double r = 1 + (v - 0.5) * 0.6 * std::cos(half);
    return Point(r * std::cos(2 * half), r * std::sin(2 * half), (v - 0.5) * 0.6 * std::sin(half));
  });
}

FlatMesh klein_bottle() {
  return band(24, 12, true, true, [](double u, double v) {  // the figure 8, turned once by half
    const double half = pi * u;
    const double phi = 2 * pi * v;
    const double a = std::cos(half) * std::sin(phi) - std::sin(half) * std::sin(2 * phi);
    const double b = std::sin(half) * std::sin(phi) + std::cos(half) * std::sin(2 * phi);
    return Point((2 + a) * std::cos(2 * half), (2 + a) * std::sin(2 * half), b);
  });
}

FlatMesh unmerged(const FlatMesh& mesh) {
  FlatMesh soup;
  for (const Triangle& f : mesh.faces) {
    const std::size_t first = soup.points.size();
    for (const std::size_t v : f) soup.points.push_back(mesh.points[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// The families whose connectivity is odd.
void add_odd_connectivity(std::vector<BadMesh>& families) {
  const auto add = [&](const char* name, FlatMesh mesh) { families.push_back({name, std::move(mesh), {}, {}, ""}); };
  add("one_triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  add("two_triangles", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}}, {{0, 1, 2}, {1, 3, 2}}});
  add("fan", fan(6, 3));
  add("bow_tie", bow_tie());
  add("edge_of_three_faces", book(3));
  add("edge_of_thirty_faces", book(30));
  FlatMesh mesh = potato(1);
  for (std::size_t f = 0; f < mesh.faces.size(); f += 3) std::swap(mesh.faces[f][0], mesh.faces[f][1]);
  add("mixed_orientation", mesh);
  add("moebius_strip", moebius_strip());
  add("klein_bottle", klein_bottle());
  add("unmerged", unmerged(potato(1)));
  mesh = potato(1);
  for (std::size_t f = 0; f < 10; ++f) {
    mesh.points.push_back(mesh.points[mesh.faces[f][0]]);
    mesh.faces[f][0] = mesh.points.size() - 1;
  }
  add("duplicate_vertices", mesh);
  mesh = potato(1);
  for (std::size_t f = 0; f < 20; ++f) mesh.faces.push_back(mesh.faces[f]);
  add("duplicate_faces", mesh);
  mesh = sheet();
  for (const Triangle& f : sheet().faces) mesh.faces.push_back({f[0], f[2], f[1]});
  add("faces_back_to_back", mesh);
  mesh = potato(1);
  for (std::size_t k = 0; k < 10; ++k) mesh.faces.push_back({k, k, k + 20});
  mesh.faces.push_back({3, 3, 3});
  add("repeated_vertex_in_a_face", mesh);
  mesh = sheet();
  for (int k = 0; k < 5; ++k) mesh.points.push_back(mesh.points[3] * 1.01 + Point(0, 0, k));
  add("isolated_vertices", mesh);
  mesh = potato(1);
  append(mesh, transformed(octahedron(), [](const Point& p) { return p * 0.2 + Point(0.5, 0, 0); }));
  append(mesh, transformed(sheet(4), [](const Point& p) { return p + Point(30, 0, 0); }));
  add("disconnected_parts", mesh);
  mesh = potato(2);
  mesh.faces.erase(mesh.faces.begin() + 40, mesh.faces.begin() + 60);
  mesh.faces.erase(mesh.faces.begin() + 100);
  add("holes", mesh);
  add("valence_10000", cone(10000));
  families.back().large_support = true;
}

/// The families with vertices of more faces than the fast march has bits for.
void add_high_valence(std::vector<BadMesh>& families) {
  for (auto& [name, mesh] : high_valence_meshes(60)) families.push_back({"hub_" + name, std::move(mesh), {}, {}, ""});
}

/// The families whose faces have odd shapes.
void add_odd_shapes(std::vector<BadMesh>& families) {
  const auto add = [&](const char* name, FlatMesh mesh) { families.push_back({name, std::move(mesh), {}, {}, ""}); };
  FlatMesh mesh = potato(1);
  const Triangle collapsed = mesh.faces[30];
  mesh.points[collapsed[0]] = mesh.points[collapsed[1]];
  add("zero_length_edge", mesh);
  mesh = sheet();
  mesh.points.push_back((mesh.points[16] + mesh.points[17]) / 2);
  mesh.faces.push_back({16, mesh.points.size() - 1, 17});
  add("collinear_face", mesh);
  add("no_face_with_area", transformed(grid(4), [](const Point& p) { return Point(p[0] + 4 * p[1], 0, 0); }));
  mesh = sheet();
  for (const std::size_t v : {10, 24, 25}) mesh.points[v][2] = 1000;
  add("spikes", mesh);
  add("needles", transformed(sheet(), [](const Point& p) { return Point(p[0] * 1e8, p[1] + 1e-8 * p[0], p[2]); }));
  // Each row of the strip is ten times as far from the last one, and as long.
  add("edges_from_1e-6_to_1e6", transformed(sheet(13), [](const Point& p) {
        const double size = std::pow(10, 12 * p[0] - 6);
        return Point(size, size * p[1], size * p[2]);
      }));
}

/// The families whose coordinates are odd.
void add_odd_coordinates(std::vector<BadMesh>& families, double smallest, double largest) {
  const auto add = [&](const char* name, FlatMesh mesh) { families.push_back({name, std::move(mesh), {}, {}, ""}); };
  add("national_grid", transformed(sheet(), [](const Point& p) { return p * 0.05 + Point(432100, 5432100, 300); }));
  add("at_1e-20", scaled(potato(1), 1e-20));
  add("at_1e20", scaled(potato(1), 1e20));
  add("denormal_coordinates", scaled(potato(1), smallest * 1000));
  families.back().has_figures = false;
  add("largest_coordinates", scaled(octahedron(), largest / 2));
  families.back().has_figures = false;
  FlatMesh mesh = potato(1);
  mesh.points.emplace_back(0, 1e30, 0);
  add("stray_vertex_at_1e30", mesh);
}

/// The families that no filter can work on.
void add_refused(std::vector<BadMesh>& families) {
  const auto add = [&](const char* name, FlatMesh mesh, const char* error) {
    families.push_back({name, std::move(mesh), {}, {}, error});
  };
  add("empty", {}, "has no faces");
  add("points_only", {sheet().points, {}}, "has no faces");
  add("all_vertices_in_one_place", scaled(sheet(), 0), "no edge of any length");
  add("only_repeated_vertices", {sheet().points, {{0, 0, 1}, {2, 3, 3}}}, "no edge of any length");
  const auto add_with = [&](const char* name, double value, bool everywhere, const char* error) {
    FlatMesh mesh = sheet();
    for (Point& p : mesh.points)
      if (everywhere) p = Point(value, value, value);
    mesh.points[5][1] = value;
    add(name, std::move(mesh), error);
  };
  add_with("nan_in_one_place", not_a_number, false, "1 vertex has a coordinate that is not a finite number");
  add_with("nan_everywhere", not_a_number, true, "49 vertices have a coordinate that is not a finite number");
  add_with("infinity_in_one_place", infinity, false, "1 vertex has a coordinate that is not a finite number");
  add_with("infinity_everywhere", -infinity, true, "49 vertices have a coordinate that is not a finite number");
  for (const auto& [name, index] : {std::pair("index_one_too_far", std::size_t(49)), {"index_far_out", 1u << 30}}) {
    FlatMesh mesh = sheet();
    mesh.faces[7][1] = index;
    add(name, std::move(mesh), "face 7 refers to a vertex that the mesh does not have");
    families.back().within_a_file = false;
  }
}

/// The families with elements that are marked as deleted, as MeshLab leaves them until it compacts.
void add_deleted(std::vector<BadMesh>& families) {
  BadMesh bad{"deleted_faces_and_vertices", sheet(), {}, {}, ""};
  bad.mesh.points.emplace_back(not_a_number, 0, 0);  // what is deleted may be anything
  bad.deleted_vertices = {bad.mesh.points.size() - 1};
  for (std::size_t f = 0; f < bad.mesh.faces.size(); ++f)
    if (std::count(bad.mesh.faces[f].begin(), bad.mesh.faces[f].end(), 24u) > 0) bad.deleted_faces.push_back(f);
  bad.deleted_vertices.push_back(24);
  bad.within_a_file = false;
  families.push_back(bad);

  bad = {"vertex_deleted_under_its_faces", sheet(), {24}, {}, "refers to a vertex that the mesh does not have"};
  bad.within_a_file = false;
  families.push_back(bad);

  bad = {"all_deleted", octahedron(), {0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4, 5, 6, 7}, "has no faces"};
  bad.within_a_file = false;
  families.push_back(bad);
}

}  // namespace

std::vector<BadMesh> bad_meshes(double smallest, double largest) {
  std::vector<BadMesh> families;
  add_odd_connectivity(families);
  add_high_valence(families);
  add_odd_shapes(families);
  add_odd_coordinates(families, smallest, largest);
  add_deleted(families);
  add_refused(families);
  return families;
}

std::vector<std::string> bad_mesh_names() {
  std::vector<std::string> names;
  for (const BadMesh& bad : bad_meshes<double>()) names.push_back(bad.name);
  return names;
}

}  // namespace test_support
