// SPDX-License-Identifier: GPL-3.0-or-later
// Files as programs write them, against the letter of their formats or at its edge: what is read from them, and that
// they come back byte for byte.

#include <mesh_tools/mesh_io.h>

#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using mesh_tools::MeshFile;
using mesh_tools::OriginalFile;

class OddFiles : public tools_tests::TemporaryFolder {
 protected:
  /// Reads a file, and expects that it is written as it is, and as a file of the moved mesh when its vertices move.
  MeshFile read(const std::string& name, const std::string& bytes, std::size_t warnings = 0) {
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(write(name, bytes), &original);
    EXPECT_EQ(file.warnings.size(), warnings) << name;
    const fs::path out = path("out" + path(name).extension().string());
    EXPECT_TRUE(mesh_tools::write_moved(file, original, out, true).empty());
    EXPECT_EQ(bytes_of(out), bytes);
    for (auto& vertex : file.mesh.vert) vertex.P() += vcg::Point3d(1, 2, 4);
    mesh_tools::write_moved(file, original, out, true);
    const MeshFile moved = mesh_tools::read_mesh(out);
    for (auto& vertex : file.mesh.vert) vertex.P() -= vcg::Point3d(1, 2, 4);
    EXPECT_EQ(moved.mesh.vn, file.mesh.vn);
    EXPECT_EQ(moved.mesh.fn, file.mesh.fn);
    for (std::size_t v = 0; v < file.mesh.vert.size() && moved.mesh.vn == file.mesh.vn; ++v)
      EXPECT_EQ(moved.mesh.vert[v].cP(), file.mesh.vert[v].cP() + vcg::Point3d(1, 2, 4)) << name;
    return file;
  }

  /// The three vertices and one face that most files here hold.
  static void expect_triangle(const MeshFile& file) {
    ASSERT_EQ(file.mesh.vn, 3);
    ASSERT_EQ(file.mesh.fn, 1);
    const vcg::Point3d places[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int k = 0; k < 3; ++k) EXPECT_EQ(file.mesh.face[0].cP(k), places[k]);
  }

  static double area(const MeshFile& file) {
    double sum = 0;
    for (const auto& face : file.mesh.face) sum += ((face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0))).Norm() / 2;
    return sum;
  }
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size()) text.replace(at, what.size(), by);
  return text;
}

const std::string bom = "\xef\xbb\xbf";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string stl =
    "solid x\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n"
    " endfacet\nendsolid x\n";

TEST_F(OddFiles, byte_order_marks_and_old_macs_line_ends) {
  for (const auto& [name, text] :
       std::map<std::string, std::string>{{"a.obj", obj}, {"a.off", off}, {"a.ply", ply}, {"a.stl", stl}}) {
    expect_triangle(read(name, bom + text));
    expect_triangle(read(name, replaced(text, "\n", "\r")));
    expect_triangle(read(name, replaced(text, "\n", "\r\n")));
  }
  write("m.mtl", bom + "newmtl red\rKd 1 0 0\r");
  const MeshFile file = read("a.obj", bom + "mtllib m.mtl\nusemtl red\n" + obj);
  EXPECT_EQ(file.mesh.face[0].cC(), vcg::Color4b(255, 0, 0, 255));
}

/// Behind a header whose lines end in CR, binary data may begin with what looks like a line feed.
TEST_F(OddFiles, binary_ply_behind_a_header_of_an_old_mac) {
  std::string bytes = replaced(replaced(ply.substr(0, ply.find("0 0 0")), "ascii", "binary_little_endian"), "\n", "\r");
  const float places[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::int32_t first = 0x3f80000a;
  std::string data(sizeof places, '\0');
  std::memcpy(data.data(), places, sizeof places);
  std::memcpy(data.data(), &first, sizeof first);
  const std::int32_t corners[3] = {0, 1, 2};
  data += '\3';
  data.append(reinterpret_cast<const char*>(corners), sizeof corners);
  const MeshFile file = mesh_tools::read_mesh(write("a.ply", bytes + data));
  EXPECT_NEAR(file.mesh.vert[0].cP()[0], 1, 1e-5);
  EXPECT_EQ(file.mesh.vert[1].cP(), vcg::Point3d(1, 0, 0));
}

TEST_F(OddFiles, concave_polygons_keep_their_area) {
  const std::string points = "0 0 0\n4 0 0\n4 4 0\n2 1 0\n0 4 0\n";
  const std::string head = replaced(ply.substr(0, ply.find("0 0 0")), "vertex 3", "vertex 5");
  EXPECT_DOUBLE_EQ(area(read("a.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 5 1 2 3 4\n")), 10);
  EXPECT_DOUBLE_EQ(area(read("a.off", "OFF\n5 1 0\n" + points + "5 4 0 1 2 3\n")), 10);
  EXPECT_DOUBLE_EQ(area(read("a.ply", head + points + "5 4 0 1 2 3\n")), 10);
  // Faces may come first, when it is not known yet where they are.
  EXPECT_DOUBLE_EQ(area(read("a.obj", "f 5 1 2 3 4\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\n")), 10);
}

TEST_F(OddFiles, a_number_sign_belongs_to_a_name) {
  write("m.mtl", "newmtl Mat#1\nKd 1 0 0\nnewmtl Mat #2\nKd 0 0 1 # blue\nmap_Kd skin#1.png\nnewmtl 3\nKd 0 1 0\n");
  const MeshFile file =
      read("a.obj",
           "# a comment\nmtllib m.mtl # ours\nv 0 0 0#1\nv 1 0 0 # 2\nv 0 1 0\nvt 0 0\nusemtl Mat#1\nf 1 2 3#4\n"
           "usemtl Mat #2\nf 1/1 2/1 3/1\nusemtl 3 # by its number \\\nf 1 2 3\n");
  ASSERT_EQ(file.mesh.fn, 3);
  EXPECT_EQ(file.mesh.face[0].cC(), vcg::Color4b(255, 0, 0, 255));
  EXPECT_EQ(file.mesh.face[1].cC(), vcg::Color4b(0, 0, 255, 255));
  EXPECT_EQ(file.mesh.face[2].cC(), vcg::Color4b(0, 255, 0, 255));
  EXPECT_EQ(file.mesh.textures, std::vector<std::string>{"skin#1.png"});
}

TEST_F(OddFiles, a_number_sign_may_begin_the_name_of_a_material_file) {
  write("#m.mtl", "newmtl red\nKd 1 0 0\n");
  EXPECT_EQ(read("a.obj", "mtllib #m.mtl\nusemtl red\n" + obj).mesh.face[0].cC(), vcg::Color4b(255, 0, 0, 255));
  // Where there is no such file it is a comment, or a file that is missing; which one, nobody can tell.
  const MeshFile missing = read("b.obj", "mtllib #none.mtl\n" + obj);
  ASSERT_EQ(missing.not_kept.size(), 1u);
  EXPECT_NE(missing.not_kept[0].find("#none.mtl: cannot be read"), std::string::npos) << missing.not_kept[0];
}

TEST_F(OddFiles, opacity_is_what_d_says_and_tr_makes_nothing_invisible) {
  const auto alpha = [&](const std::string& lines) {
    write("m.mtl", "newmtl m\nKd 1 1 1\n" + lines);
    return mesh_tools::read_mesh(write("a.obj", "mtllib m.mtl\nusemtl m\n" + obj)).mesh.face[0].cC()[3];
  };
  EXPECT_EQ(alpha(""), 255);
  EXPECT_EQ(alpha("d 1.0\nTr 0.0\n"), 255);
  EXPECT_EQ(alpha("Tr 0\n"), 255);
  EXPECT_EQ(alpha("Tr 1\n"), 255);
  EXPECT_EQ(alpha("Tr 0.8\n"), 51);
  EXPECT_EQ(alpha("Tr 0.8\nd 0.4\n"), 102);
  EXPECT_EQ(alpha("d 0\n"), 0);
  EXPECT_EQ(alpha("d -halo 0.4\n"), 102);
}

TEST_F(OddFiles, one_odd_line_of_a_material_file_is_lost_alone) {
  write("m.mtl", "newmtl m\nKd spectral a.rfl 1\nd 0.4\nnewmtl n\nKd 0 0 x\nmap_Kd -s 2 2 1 -clamp on two words.png\n");
  const MeshFile file = read("a.obj", "mtllib m.mtl\nvt 0 0\nusemtl m\n" + obj + "usemtl n\nf 1/1 2/1 3/1\n");
  EXPECT_EQ(file.mesh.face[0].cC(), vcg::Color4b(255, 255, 255, 102));
  EXPECT_EQ(file.mesh.textures, std::vector<std::string>{"two words.png"});
  ASSERT_EQ(file.not_kept.size(), 1u);
  EXPECT_NE(file.not_kept[0].find("m.mtl, line 2: 'spectral' is not a number"), std::string::npos) << file.not_kept[0];
}

TEST_F(OddFiles, a_statement_may_name_several_material_files) {
  write("a.mtl", "newmtl red\nKd 1 0 0\n");
  write("b c.mtl", "newmtl green\nKd 0 1 0\n");
  write("d.mtl", "newmtl blue\nKd 0 0 1\n");
  const MeshFile file = read("a.obj", "mtllib a.mtl  d.mtl\nmtllib b c.mtl\nusemtl red\n" + obj +
                                          "usemtl blue\nf 1 2 3\nusemtl green\nf 1 2 3\n");
  ASSERT_EQ(file.mesh.fn, 3);
  EXPECT_EQ(file.mesh.face[0].cC(), vcg::Color4b(255, 0, 0, 255));
  EXPECT_EQ(file.mesh.face[1].cC(), vcg::Color4b(0, 0, 255, 255));
  EXPECT_EQ(file.mesh.face[2].cC(), vcg::Color4b(0, 255, 0, 255));
  const MeshFile missing = read("b.obj", "mtllib a.mtl none.mtl\n" + obj);
  ASSERT_EQ(missing.not_kept.size(), 1u);
  EXPECT_NE(missing.not_kept[0].find("none.mtl: cannot be read"), std::string::npos) << missing.not_kept[0];
}

TEST_F(OddFiles, colours_are_of_one_kind_in_a_file) {
  const auto colors = [&](const std::string& name, const std::string& text) {
    const MeshFile file = read(name, text);
    EXPECT_TRUE(file.attributes & mesh_tools::vertex_color_attribute);
    return std::vector<vcg::Color4b>{file.mesh.vert[0].cC(), file.mesh.vert[1].cC(), file.mesh.vert[2].cC()};
  };
  using Colors = std::vector<vcg::Color4b>;
  const Colors fractions = {{128, 64, 26, 255}, {255, 0, 0, 255}, {255, 255, 255, 255}};
  EXPECT_EQ(colors("a.off", "COFF\n3 1 0\n0 0 0 0.5 0.25 0.1 1\n1 0 0 1 0 0 1\n0 1 0 1 1 1 1\n3 0 1 2\n"), fractions);
  EXPECT_EQ(colors("a.obj", "v 0 0 0 0.5 0.25 0.1\nv 1 0 0 1 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n"), fractions);
  const Colors bytes = {{255, 0, 0, 255}, {0, 1, 1, 255}, {1, 1, 1, 255}};
  EXPECT_EQ(colors("a.off", "COFF\n3 1 0\n0 0 0 255.0 0.0 0 255\n1 0 0 0 1 1 255\n0 1 0 1 1 1 255\n3 0 1 2\n"), bytes);
  EXPECT_EQ(colors("a.obj", "v 0 0 0 255.0 0 0\nv 1 0 0 0 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n"), bytes);
  const auto of_ply = [&](const std::string& type, const std::string& names, const std::string& a, const std::string& b,
                          const std::string& c) {
    std::string text =
        replaced(replaced(ply, "0 0 0\n1 0 0\n0 1 0\n", "0 0 0 " + a + "\n1 0 0 " + b + "\n0 1 0 " + c + "\n"),
                 "element face", names + "element face");
    return colors("a.ply", replaced(text, "TYPE", type));
  };
  const std::string rgb = "property TYPE red\nproperty TYPE green\nproperty TYPE blue\n";
  EXPECT_EQ(of_ply("float", rgb, "0.5 0.25 0.1", "1 0 0", "1 1 1"), fractions);
  EXPECT_EQ(of_ply("double", rgb, "255 0 0", "0 1 1", "1 1 1"), bytes);
  EXPECT_EQ(of_ply("ushort", rgb, "32896 16448 6682", "65535 0 0", "65535 65535 65535"), fractions);
  EXPECT_EQ(of_ply("int", rgb, "255 0 0", "0 1 1", "1 1 1"), bytes);
  EXPECT_EQ(of_ply("uchar", "property TYPE r\nproperty TYPE g\nproperty TYPE b\n", "255 0 0", "0 1 1", "1 1 1"), bytes);
}

TEST_F(OddFiles, one_letter_means_nothing_alone) {
  const std::string rows = "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n";
  const MeshFile file = read("a.ply", replaced(replaced(ply, "0 0 0\n1 0 0\n0 1 0\n", rows), "element face",
                                               "property uchar r\nproperty float u\nelement face"));
  EXPECT_EQ(file.attributes, 0);
  ASSERT_EQ(file.not_kept.size(), 1u);
  EXPECT_NE(file.not_kept[0].find("vertex.r, vertex.u"), std::string::npos) << file.not_kept[0];
}

TEST_F(OddFiles, colours_of_floats_are_written_as_floats) {
  OriginalFile original;
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float red\nproperty float green\nproperty float blue\nend_header\n";
  MeshFile file =
      mesh_tools::read_mesh(write("a.ply", head + "0 0 0 .5 .50 0\n1 0 0 1 0.2 1\n0 1 0 0 0 0\n"), &original);
  file.mesh.vert[0].C()[1] = 51;
  mesh_tools::write_moved(file, original, path("out.ply"), true);
  EXPECT_EQ(bytes_of(path("out.ply")), head + "0 0 0 .5 0.2 0\n1 0 0 1 0.2 1\n0 1 0 0 0 0\n");
}

TEST_F(OddFiles, texture_coordinates_by_other_names) {
  const auto uv = [&](const std::string& name, const std::string& text) {
    const MeshFile file = read(name, text);
    return std::pair(file.mesh.vert[1].cT().u(), file.mesh.vert[1].cT().v());
  };
  const std::string rows = "0 0 0 0 0\n1 0 0 .5 .25\n0 1 0 1 1\n";
  EXPECT_EQ(uv("a.ply", replaced(replaced(ply, "0 0 0\n1 0 0\n0 1 0\n", rows), "element face",
                                 "property float u\nproperty float v\nelement face")),
            std::pair(0.5f, 0.25f));
  EXPECT_EQ(uv("a.off", "STOFF\n3 1 0\n" + rows + "3 0 1 2\n"), std::pair(0.5f, 0.25f));
}

TEST_F(OddFiles, stl_colours_of_magics) {
  const auto colors = [&](const std::string& header, std::uint16_t own, std::uint16_t shared) {
    std::string bytes = header;
    bytes.resize(80);
    bytes.append("\2\0\0\0", 4);
    for (const std::uint16_t attribute : {own, shared}) {
      const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, static_cast<float>(1 + attribute), 0};
      bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
      bytes.append(reinterpret_cast<const char*>(&attribute), 2);
    }
    const MeshFile file = read("a.stl", bytes);
    return std::pair(file.mesh.face[0].cC(), file.mesh.face[1].cC());
  };
  using Pair = std::pair<vcg::Color4b, vcg::Color4b>;
  const std::string magics = "COLOR=\x0a\x14\x1e\xff,MATERIAL=";
  const vcg::Color4b of_header(10, 20, 30, 255), white(255, 255, 255, 255);
  EXPECT_EQ(colors(magics, 31, 0x8000), Pair(vcg::Color4b(248, 0, 0, 255), of_header));
  EXPECT_EQ(colors(magics, 31 << 10, 0xffff), Pair(vcg::Color4b(0, 0, 248, 255), of_header));
  EXPECT_EQ(colors("by VisCAM", 0x8000 | 31 << 10, 0), Pair(vcg::Color4b(248, 0, 0, 255), white));
}

TEST_F(OddFiles, a_header_of_magics_without_colours_of_facets_colours_all) {
  std::string bytes = "COLOR=\x0a\x14\x1e\xff";
  bytes.resize(80);
  bytes.append("\1\0\0\0", 4);
  const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers).append(2, '\0');
  EXPECT_EQ(read("a.stl", bytes).mesh.face[0].cC(), vcg::Color4b(10, 20, 30, 255));
}

TEST_F(OddFiles, off_with_free_white_space) {
  expect_triangle(read("a.off", "OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  expect_triangle(read("a.off", "OFF\n3 1 0\n0 0 0 1 0 0\n0 1\n0 3 0\n1 2\n"));
  expect_triangle(read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0\n1\n2 9 9 9\n"));
  const MeshFile file = read("a.off",
                             "CNOFF\n3 2\n0 0 0 0 0 1 7 8 9 255\n1 0 0 0 0 1\n1 2 3 4 0 1 0\n0 0 1 0 0 0 255 3 0 1 2 9 "
                             "8 7\n3 0 1 2\n");
  EXPECT_EQ(file.mesh.fn, 2);
}

TEST_F(OddFiles, text_stl_as_programs_write_it) {
  expect_triangle(read("a.stl", replaced(stl, "facet", "FACET")));
  std::string capitals = stl;
  for (char& c : capitals) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  expect_triangle(read("a.stl", capitals));
  expect_triangle(read("a.stl", " \n\n \t" + stl));
  expect_triangle(read("a.stl", replaced(stl, " normal 0 0 1", "")));
  expect_triangle(read("a.stl", replaced(stl, "facet normal", "facet")));
  expect_triangle(read("a.stl", replaced(stl, "endfacet", "endfacet blah")));
  expect_triangle(read("a.stl", replaced(stl, " facet", "; made by nobody\n facet")));
}

TEST_F(OddFiles, binary_stl_with_more_behind_it_or_a_count_that_is_too_small) {
  std::string bytes(80, ' ');
  bytes.append("\1\0\0\0", 4);
  const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::string facet = std::string(reinterpret_cast<const char*>(numbers), sizeof numbers) + std::string(2, '\0');
  bytes += facet;
  expect_triangle(read("a.stl", bytes));
  expect_triangle(read("a.stl", bytes + "\n", 1));
  expect_triangle(read("a.stl", "solid" + bytes.substr(5) + "\r\n", 1));
  EXPECT_EQ(read("a.stl", bytes + facet + facet, 1).mesh.fn, 3);
  bytes[80] = 0;
  EXPECT_EQ(read("a.stl", bytes + facet, 1).mesh.fn, 2);
  EXPECT_THROW(mesh_tools::read_mesh(write("a.stl", bytes + "\n")), mesh_tools::FileError);
}

TEST_F(OddFiles, faces_of_too_few_corners_are_passed_over_with_a_warning) {
  for (const char* few : {"f 1\n", "f 1 2\n", "f\n"}) expect_triangle(read("a.obj", obj + few, 1));
  for (const char* few : {"1 2\n", "1 2 255 0 0\n", "2 0 1\n", "2 0 1 7\n"})
    expect_triangle(read("a.off", replaced(off, "3 1 0", "3 2 0") + few, 1));
  for (const char* few : {"0\n", "1 2\n", "2 0 1\n"}) {
    expect_triangle(read("a.ply", replaced(ply, "face 1", "face 2") + few, 1));
  }
  // Within a line it is no face: the file's counts are wrong.
  EXPECT_THROW(mesh_tools::read_mesh(write("a.ply", replaced(replaced(ply, "face 1", "face 2"), "2\n", "2 0\n"))),
               mesh_tools::FileError);
}

TEST_F(OddFiles, ply_coordinates_of_any_type) {
  for (const char* type : {"char", "ushort", "int", "double"}) {
    const std::string bytes = replaced(ply, "float z", std::string(type) + " z");
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(write("a.ply", bytes), &original);
    expect_triangle(file);
    EXPECT_TRUE(mesh_tools::write_moved(file, original, path("out.ply"), false).empty());
    EXPECT_EQ(bytes_of(path("out.ply")), bytes);
    file.mesh.vert[1].P()[2] = 0.25;
    const auto lost = mesh_tools::write_moved(file, original, path("out.ply"), false);
    ASSERT_EQ(lost.size(), std::string(type) == "double" ? 0u : 1u);
    if (!lost.empty()) {
      EXPECT_NE(lost[0].find("a.ply: its coordinates are whole numbers"), std::string::npos) << lost[0];
    }
    EXPECT_EQ(mesh_tools::read_mesh(path("out.ply")).mesh.vert[1].cP(), vcg::Point3d(1, 0, 0.25));
  }
}

TEST_F(OddFiles, ply_headers_as_programs_write_them) {
  expect_triangle(read("a.ply", "\n \n" + ply));
  expect_triangle(
      read("a.ply", replaced(ply, "element face", "comment " + std::string(100000, 'x') + "\nelement face")));
  const MeshFile file =
      read("a.ply", replaced(ply, "element face", "Created by Blender 2.79 - www.blender.org\nelement face"), 1);
  expect_triangle(file);
  EXPECT_NE(file.warnings[0].find("line 7 of the header, 'Created by Blender"), std::string::npos) << file.warnings[0];
}

TEST_F(OddFiles, obj_that_refers_to_what_comes_later) {
  expect_triangle(read("a.obj", "f 1/1/1 2/2/1 3/1/1\nvn 0 0 1\nvt 0\nv 0 0 0\nv 1 0 0\nvt 0.5\nv 0 1 0\n"));
  const MeshFile file = read("a.obj", "vt 0.5\nvt 0.25 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/1\n");
  EXPECT_EQ(file.mesh.face[0].cWT(0).u(), 0.5f);
  EXPECT_EQ(file.mesh.face[0].cWT(0).v(), 0.0f);
  EXPECT_EQ(file.mesh.face[0].cWT(1).v(), 1.0f);
}

TEST_F(OddFiles, obj_with_normals_that_are_not_there) {
  for (const char* face : {"f 1//1 2//0 3//1\n", "f 1//1 2//9 3//1\n", "f 1//1 2//-2 3//1\n"})
    expect_triangle(read("a.obj", "vn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + std::string(face), 1));
}

}  // namespace
