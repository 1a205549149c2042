// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh keeps when it is written in another format, or for another folder.

#include <mesh_tools/mesh_io.h>

#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "io/formats.h"
#include "io/polygons.h"
#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using mesh_tools::MeshFile;
using mesh_tools::OriginalFile;

class Conversion : public tools_tests::TemporaryFolder {
 protected:
  /// Reads a file, writes it elsewhere with nothing moved, and reads that.
  MeshFile converted(const fs::path& input, const std::string& name, std::size_t warnings = 0) {
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(input, &original);
    lost_ = mesh_tools::write_moved(file, original, path(name), false);
    EXPECT_EQ(lost_.size(), warnings) << input << " to " << name;
    return mesh_tools::read_mesh(path(name));
  }

  /// The vertices of each polygon, each from its first corner.
  static std::vector<std::vector<std::size_t>> polygons(const MeshFile& file) {
    std::vector<std::vector<std::size_t>> result;
    mesh_tools::io::visit_polygons(file, [&](std::size_t, const std::uint32_t* first, const std::uint32_t* last) {
      auto& polygon = result.emplace_back();
      for (; first != last; ++first)
        polygon.push_back(vcg::tri::Index(file.mesh, file.mesh.face[*first / 3].cV(static_cast<int>(*first % 3))));
    });
    return result;
  }

  std::vector<std::string> lost_;
};

/// A triangle, a square and a concave polygon of five corners.
const std::string mixed =
    "OFF\n9 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 0\n4 4 0\n2 2.5 0\n0 4 0\n0 0 1\n"
    "3 0 1 8 255 0 0\n4 0 1 2 3 0 255 0\n5 3 2 5 6 7 0 0 255\n";

TEST_F(Conversion, polygons_stay_polygons) {
  const std::vector<std::vector<std::size_t>> expected = {{0, 1, 8}, {0, 1, 2, 3}, {3, 2, 5, 6, 7}};
  fs::path from = write("a.off", mixed);
  EXPECT_EQ(polygons(mesh_tools::read_mesh(from)), expected);
  for (const char* to : {"a.ply", "a.obj", "b.off", "b.obj", "b.ply", "c.off"}) {
    const MeshFile file = converted(from, to);
    EXPECT_EQ(polygons(file), expected) << to;
    ASSERT_EQ(file.mesh.fn, 6);
    const unsigned char red[6] = {255, 0, 0, 0, 0, 0}, blue[6] = {0, 0, 0, 255, 255, 255};
    for (std::size_t f = 0; f < 6; ++f) {
      EXPECT_EQ(file.mesh.face[f].cC()[0], red[f]) << to;
      EXPECT_EQ(file.mesh.face[f].cC()[2], blue[f]) << to;
    }
    from = path(to);
  }
  EXPECT_EQ(converted(from, "a.stl", 1).mesh.fn, 6);
  EXPECT_NE(lost_[0].find("2 polygons were cut into triangles"), std::string::npos) << lost_[0];
}

TEST_F(Conversion, large_polygons_fit_into_ply) {
  for (const int corners : {127, 128, 255, 256, 1000}) {
    std::string text, face = "f";
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * i / corners;
      text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\nvt 0 " +
              std::to_string(i) + "\n";
      face.append(" ").append(std::to_string(i + 1)).append("/").append(std::to_string(i + 1));
    }
    const MeshFile file =
        converted(converted(write("a.obj", text + face + "\n"), "a.ply").folder.value() / "a.ply", "b.obj");
    ASSERT_EQ(polygons(file).size(), 1u);
    ASSERT_EQ(polygons(file)[0].size(), static_cast<std::size_t>(corners));
    for (const auto& triangle : file.mesh.face)
      for (int k = 0; k < 3; ++k)
        ASSERT_EQ(triangle.cWT(k).v(), static_cast<float>(vcg::tri::Index(file.mesh, triangle.cV(k))));
  }
}

/// Each corner keeps its own, also where the polygon is not cut into a fan.
TEST_F(Conversion, texture_coordinates_stay_with_the_corners_of_concave_polygons) {
  const MeshFile file =
      converted(write("a.obj",
                      "v 0 4 0\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nvt 0 0\nvt 0 1\nvt 0 2\nvt 0 3\nvt 0 4\n"
                      "f 1/1 2/2 3/3 4/4 5/5\n"),
                "a.ply");
  ASSERT_EQ(file.mesh.fn, 3);
  for (const auto& face : file.mesh.face)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(face.cWT(k).v(), static_cast<float>(vcg::tri::Index(file.mesh, face.cV(k))));
}

TEST_F(Conversion, faces_without_texture_stay_without) {
  const fs::path obj = write("a.obj",
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 1 3 2\n"
                             "f 1/1 2 3/3\n");
  for (const char* to : {"a.ply", "b.obj"}) {
    const MeshFile file = converted(to[0] == 'a' ? obj : path("a.ply"), to);
    ASSERT_EQ(file.mesh.fn, 3);
    EXPECT_EQ(file.mesh.face[0].cWT(1).u(), 1) << to;
    EXPECT_FALSE(std::isnan(file.mesh.face[0].cWT(0).u()));
    EXPECT_TRUE(std::isnan(file.mesh.face[1].cWT(0).u())) << to;
    EXPECT_TRUE(std::isnan(file.mesh.face[2].cWT(0).u())) << to;
  }
}

TEST_F(Conversion, texture_coordinates_of_vertices_become_those_of_corners_in_obj) {
  const MeshFile file = converted(
      write(
          "a.ply",
          "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nproperty float s\nproperty float t\nelement face 1\n"
          "property list uchar int vertex_indices\nend_header\n0 0 0 .5 .25\n1 0 0 1 2\n0 1 0 3 4\n3 0 1 2\n"),
      "a.obj");
  EXPECT_EQ(file.mesh.face[0].cWT(0).u(), 0.5f);
  EXPECT_EQ(file.mesh.face[0].cWT(0).v(), 0.25f);
  EXPECT_EQ(file.mesh.face[0].cWT(2).v(), 4.0f);
  EXPECT_EQ(file.mesh.textures, std::vector<std::string>{"skin.png"});
}

class TextureNames : public Conversion {
 protected:
  void SetUp() override {
    Conversion::SetUp();
    fs::create_directories(path("in/maps"));
    fs::create_directories(path("in/materials"));
    fs::create_directories(path("out"));
    for (const char* name : {"in/skin.png", "in/maps/skin 2.png", "in/materials/wood.png"}) write(name, "a picture");
  }

  /// What a texture of a material is called in a file elsewhere.
  std::string name_in(const std::string& to, const std::string& texture, const std::string& library = "m.mtl") {
    write("in/" + library, "newmtl m\nmap_Kd " + texture + "\n");
    const fs::path input =
        write("in/a.obj", "mtllib " + library + "\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    const MeshFile file = converted(input, to);
    return file.mesh.textures.at(0);
  }
};

TEST_F(TextureNames, lead_to_the_same_files_from_another_folder) {
  EXPECT_EQ(name_in("in/a.ply", "skin.png"), "skin.png");
  EXPECT_EQ(name_in("out/a.ply", "skin.png"), "../in/skin.png");
  EXPECT_EQ(name_in("out/a.ply", "-s 2 2 1 skin.png"), "../in/skin.png");
  EXPECT_EQ(name_in("out/a.ply", "maps\\skin 2.png"), "../in/maps/skin 2.png");
  EXPECT_EQ(name_in("a.ply", "./maps/../skin.png"), "in/skin.png");
  EXPECT_EQ(name_in("in/a.ply", "wood.png", "materials/m.mtl"), "materials/wood.png");
  EXPECT_EQ(name_in("out/a.ply", "wood.png", "materials/m.mtl"), "../in/materials/wood.png");
  // What is not there, or has a place of its own, is left alone.
  EXPECT_EQ(name_in("out/a.ply", "none.png"), "none.png");
  EXPECT_EQ(name_in("out/a.ply", "/pictures/none.png"), "/pictures/none.png");
}

TEST_F(TextureNames, of_ply_follow_the_file_too) {
  const std::string head = "ply\nformat ascii 1.0\ncomment TextureFile skin.png\ncomment TextureFile none.png\n";
  std::string rest = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const bool binary : {false, true}) {
    std::string in_place = head + rest + "0 0 0\n";
    if (binary) {
      in_place = head + rest + std::string(12, '\0');
      in_place.replace(in_place.find("ascii"), 5, "binary_big_endian");
    }
    const fs::path input = write("in/a.ply", in_place);
    EXPECT_EQ(converted(input, "out/a.ply").mesh.textures, (std::vector<std::string>{"../in/skin.png", "none.png"}));
    std::string expected = in_place;
    expected.replace(expected.find("skin.png"), 8, "../in/skin.png");
    EXPECT_EQ(bytes_of(path("out/a.ply")), expected);
    converted(input, "in/b.ply");
    EXPECT_EQ(bytes_of(path("in/b.ply")), in_place);
  }
}

}  // namespace
