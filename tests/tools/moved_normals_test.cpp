// SPDX-License-Identifier: GPL-3.0-or-later
// Normals in a file whose vertices moved: of the same structure as before, and right.

#include <mesh_tools/mesh_io.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>

#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using mesh_tools::Mesh;
using mesh_tools::MeshFile;
using mesh_tools::OriginalFile;
using vcg::Point3d;

/// A rotation that mixes all axes.
Point3d turned(const Point3d& p) {
  vcg::Matrix33d rotation;
  rotation.SetRotateRad(1.1, Point3d(1, 2, -0.5).Normalize());
  return rotation * p;
}

std::string text(const Point3d& p) {
  std::string result;
  for (int k = 0; k < 3; ++k) {
    char digits[64];
    result.append(" ").append(digits, std::to_chars(digits, digits + sizeof digits, p[k]).ptr);
  }
  return result;
}

std::vector<std::string> lines_of(const std::string& bytes) {
  std::vector<std::string> lines;
  std::istringstream in(bytes);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The last three numbers of a line.
Point3d normal_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  Point3d normal;
  for (int k = 0; k < 3; ++k) normal[k] = std::stod(words.at(words.size() - 3 + static_cast<std::size_t>(k)));
  return normal;
}

class MovedNormals : public tools_tests::TemporaryFolder {
 protected:
  template <class Move>
  std::vector<std::string> moved(const fs::path& input, const Move& move) {
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(input, &original);
    for (auto& vertex : file.mesh.vert) vertex.P() = move(vertex.cP());
    const fs::path out = path("out" + input.extension().string());
    mesh_tools::write_moved(file, original, out, false);
    return lines_of(bytes_of(out));
  }

  /// Whether a turned file has turned normals, wherever `holds_normal` says that a line ends in one.
  template <class Holds>
  void expect_normals_turn(const fs::path& input, const Holds& holds_normal, std::size_t normals) {
    const std::vector<std::string> before = lines_of(bytes_of(input)), after = moved(input, turned);
    ASSERT_EQ(before.size(), after.size());
    std::size_t found = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!holds_normal(before[i])) continue;
      ++found;
      ASSERT_LT((normal_of(after[i]) - turned(normal_of(before[i]))).Norm(), 1e-12) << before[i] << "\n" << after[i];
    }
    EXPECT_EQ(found, normals);
  }
};

bool is_vn(const std::string& line) { return line.compare(0, 3, "vn ") == 0; }

constexpr const char* cube_corners =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 1 0 0\nvn 0 1 0\nvn -1 0 0\n";

TEST_F(MovedNormals, normals_that_faces_share_stay_those_of_faces) {
  expect_normals_turn(
      write("cube.obj", std::string(cube_corners) +
                            "f 1//1 4//1 3//1 2//1\nf 5//2 6//2 7//2 8//2\nf 1//3 2//3 6//3 5//3\n"
                            "f 2//4 3//4 7//4 6//4\nf 3//5 4//5 8//5 7//5\nf -8//-1 -4//-1 -1//-1 -5//-1\n"),
      is_vn, 6);
}

TEST_F(MovedNormals, normals_that_follow_their_vertices_stay_smooth_in_obj) {
  const Mesh mesh = mesh_tools::make_shape("sphere", 200);
  const std::vector<Point3d> normals = mesh_tools::vertex_normals(mesh);
  std::string shared, per_corner, faces;
  std::size_t corner = 0;
  for (std::size_t v = 0; v < normals.size(); ++v)
    shared += "v" + text(mesh.vert[v].cP()) + "\nvn" + text(normals[v]) + "\n";
  for (const auto& vertex : mesh.vert) per_corner += "v" + text(vertex.cP()) + "\n";
  for (const auto& face : mesh.face) {
    faces += "f";
    std::string line = "f";
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = vcg::tri::Index(mesh, face.cV(k));
      const std::string name = std::to_string(v + 1);
      faces += " " + name + "//" + name;
      per_corner += "vn" + text(normals[v]) + "\n";
      line += " " + name + "//" + std::to_string(++corner);
    }
    faces += "\n";
    per_corner += line + "\n";
  }
  expect_normals_turn(write("shared.obj", shared + faces), is_vn, normals.size());
  expect_normals_turn(write("per_corner.obj", per_corner), is_vn, corner);
}

std::string ply_head(std::size_t vertices, std::size_t faces, bool vertex_normals, bool face_normals) {
  const std::string normal = "property double nx\nproperty double ny\nproperty double nz\n";
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty double x\nproperty double y\nproperty double z\n" + (vertex_normals ? normal : "") +
         "element face " + std::to_string(faces) + "\nproperty list uchar int vertex_indices\n" +
         (face_normals ? normal : "") + "end_header\n";
}

TEST_F(MovedNormals, seams_stay_smooth_and_edges_sharp_in_ply_and_off) {
  const auto has_normal = [](const std::string& line) { return std::count(line.begin(), line.end(), ' ') == 5; };
  for (const char* shape : {"sphere", "cube"}) {
    // Three vertices for every face, so that all edges are seams: on the sphere with one normal, on the cube with its
    // faces' own.
    const Mesh mesh = mesh_tools::make_shape(shape, 200);
    const std::vector<Point3d> smooth = mesh_tools::vertex_normals(mesh);
    std::string vertices, faces;
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
      for (int k = 0; k < 3; ++k) {
        Point3d normal = smooth[vcg::tri::Index(mesh, mesh.face[f].cV(k))];
        if (std::string(shape) == "cube") {
          normal = vcg::TriangleNormal(mesh.face[f]).Normalize();
          for (int a = 0; a < 3; ++a) normal[a] = std::round(normal[a]) + 0.0;
        }
        vertices += text(mesh.face[f].cP(k)).substr(1) + text(normal) + "\n";
      }
      const std::size_t first = 3 * f;
      faces += "3 " + std::to_string(first) + " " + std::to_string(first + 1) + " " + std::to_string(first + 2) + "\n";
    }
    const std::size_t count = 3 * mesh.face.size();
    expect_normals_turn(write("seams.ply", ply_head(count, mesh.face.size(), true, false) + vertices + faces),
                        has_normal, count);
    expect_normals_turn(write("seams.off", "NOFF\n" + std::to_string(count) + " " + std::to_string(mesh.face.size()) +
                                               " 0\n" + vertices + faces),
                        has_normal, count);
  }
}

TEST_F(MovedNormals, polygons_have_one_normal_also_where_they_are_concave) {
  const std::string corners = "0 0 0\n2 0 0\n2 2 0\n1 0.5 0\n0 2 0\n";
  expect_normals_turn(
      write("a.ply", ply_head(5, 1, false, true) + corners + "5 0 1 2 3 4 0 0 1\n"),
      [](const std::string& line) { return line.compare(0, 2, "5 ") == 0; }, 1);
  std::string obj;
  for (const std::string& line : lines_of(corners)) obj += "v " + line + "\nvn 0 0 1\n";
  expect_normals_turn(write("a.obj", obj + "f 1//1 2//2 3//3 4//4 5//5\n"), is_vn, 5);
}

TEST_F(MovedNormals, a_corner_that_points_inwards_counts_with_the_angle_inside) {
  // A prism; at each corner a cap with the polygon's inner angle and two upright faces with right angles.
  const double corner[5][2] = {{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}};
  const Point3d up(0, 0, 1);
  std::string obj, bottom, top, sides;
  for (const double z : {0.0, 1.0})
    for (int i = 0; i < 5; ++i) {
      const auto place = [&](int k) { return Point3d(corner[k % 5][0], corner[k % 5][1], z); };
      const Point3d next = (place(i + 1) - place(i)).Normalize(), last = (place(i) - place(i + 4)).Normalize();
      const double angle = M_PI - std::atan2((last ^ next) * up, last * next);
      const Point3d sum = up * (angle * (2 * z - 1)) + ((next ^ up) + (last ^ up)) * (M_PI / 2);
      obj += "v" + text(place(i)) + "\nvn" + text(Point3d(sum).Normalize()) + "\n";
    }
  const auto name = [](int v) { return " " + std::to_string(v + 1) + "//" + std::to_string(v + 1); };
  for (int i = 0; i < 5; ++i) {
    bottom += name(4 - i);
    top += name(5 + i);
    sides += "f" + name(i) + name((i + 1) % 5) + name(5 + (i + 1) % 5) + name(5 + i) + "\n";
  }
  expect_normals_turn(write("prism.obj", obj + "f" + bottom + "\nf" + top + "\n" + sides), is_vn, 10);
}

TEST_F(MovedNormals, only_normals_near_what_moved_change) {
  const Mesh mesh = mesh_tools::make_shape("sphere", 200);
  std::string obj;
  for (const auto& vertex : mesh.vert) obj += "v" + text(vertex.cP()) + "\nvn 9 9.00 9\n";
  for (const auto& face : mesh.face) {
    obj += "f";
    for (int k = 0; k < 3; ++k) {
      const std::string name = std::to_string(vcg::tri::Index(mesh, face.cV(k)) + 1);
      obj += " " + name + "//" + name;
    }
    obj += "\n";
  }
  const Point3d place = mesh.vert[11].cP();
  std::vector<bool> beside(mesh.vert.size());
  for (const auto& face : mesh.face)
    for (int k = 0; k < 3; ++k)
      if (face.cP(k) == place)
        for (int c = 0; c < 3; ++c) beside[vcg::tri::Index(mesh, face.cV(c))] = true;
  const std::vector<std::string> before = lines_of(obj), after = moved(write("a.obj", obj), [&](const Point3d&p) {
                                                           return p == place ? p * 1.1 : p;
                                                         });
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!is_vn(before[i])) {
      EXPECT_EQ(before[i] == after[i], i != 22) << "line " << i;
      continue;
    }
    EXPECT_EQ(before[i] != after[i], beside[i / 2]) << "vertex " << i / 2;
    if (!beside[i / 2]) continue;
    EXPECT_NEAR(normal_of(after[i]).Norm(), 1, 1e-12);
  }
}

TEST_F(MovedNormals, without_a_direction_they_stay) {
  const auto to_a_point = [](const Point3d&) { return Point3d(1, 2, 3); };
  const std::string ply = ply_head(3, 1, true, true);
  EXPECT_EQ(moved(write("a.ply", ply + "0 0 0 0 0 1.0\n1 0 0 0 0 1.0\n0 1 0 nan 0 1.0\n3 0 1 2 0 0 1.0\n"), to_a_point),
            lines_of(ply + "1 2 3 0 0 1.0\n1 2 3 0 0 1.0\n1 2 3 nan 0 1.0\n3 0 1 2 0 0 1.0\n"));
  const std::string rest = "vn 0 0 1\nvn 4 5 6\nvn nan inf -0\nf 1//1 2//1 3//3\nf 1//1 1//1 1//1\n";
  EXPECT_EQ(moved(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + rest), to_a_point),
            lines_of("v 1 2 3\nv 1 2 3\nv 1 2 3\n" + rest));
  const std::string facet = "facet normal x 0 1e999\nouter loop\n", end = "endloop\nendfacet\nendsolid\n";
  EXPECT_EQ(moved(write("a.stl", "solid\n" + facet + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n" + end), to_a_point),
            lines_of("solid\n" + facet + "vertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\n" + end));
}

}  // namespace
