// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/mesh_io.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <mesh_tools/random.h>
#include <mesh_tools/shapes.h>
#include <wrap/io_trimesh/io_mask.h>

#include "temporary_folder.h"

namespace {

using mesh_tools::Mesh;
using mesh_tools::MeshFile;
using mesh_tools::Precision;
using Mask = vcg::tri::io::Mask;

class MeshIo : public tools_tests::TemporaryFolder {};

constexpr int all_of_ply = Mask::IOM_VERTNORMAL | Mask::IOM_VERTCOLOR | Mask::IOM_VERTQUALITY | Mask::IOM_VERTFLAGS |
                           Mask::IOM_VERTTEXCOORD | Mask::IOM_VERTRADIUS | Mask::IOM_FACECOLOR | Mask::IOM_FACEQUALITY |
                           Mask::IOM_FACEFLAGS | Mask::IOM_FACENORMAL | Mask::IOM_WEDGTEXCOORD;

/// A cube with different values in every attribute, coordinates that no short decimal gives.
MeshFile decorated(Precision precision, int attributes) {
  MeshFile file;
  file.mesh = mesh_tools::make_shape("cube", 200);
  file.precision = precision;
  file.attributes = attributes;
  file.mesh.textures = {"bricks.png", "wood.png"};
  mesh_tools::Random random(1);
  const auto stored = [&](double value) {
    return precision == Precision::single_precision ? static_cast<double>(static_cast<float>(value)) : value;
  };
  for (auto& vertex : file.mesh.vert) {
    for (int k = 0; k < 3; ++k) {
      vertex.P()[k] = stored(vertex.P()[k] + random.uniform() / 3);
      vertex.N()[k] = stored(random.uniform());
    }
    for (int k = 0; k < 4; ++k) vertex.C()[k] = static_cast<unsigned char>(256 * random.uniform());
    vertex.Q() = stored(random.normal());
    vertex.R() = static_cast<float>(random.uniform());
    vertex.T().u() = static_cast<float>(random.uniform());
    vertex.T().v() = static_cast<float>(random.uniform());
    if (random.uniform() < 0.3) vertex.SetS();
  }
  for (auto& face : file.mesh.face) {
    for (int k = 0; k < 3; ++k) {
      face.N()[k] = stored(random.uniform());
      face.WT(k).u() = static_cast<float>(random.uniform());
      face.WT(k).v() = static_cast<float>(random.uniform());
      face.WT(k).n() = vcg::tri::Index(file.mesh, face) % 2;
    }
    face.WT(1).n() = face.WT(2).n() = face.WT(0).n();
    for (int k = 0; k < 4; ++k) face.C()[k] = static_cast<unsigned char>(256 * random.uniform());
    face.Q() = stored(random.normal());
    if (random.uniform() < 0.3) face.SetS();
  }
  return file;
}

void expect_same_geometry(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.vn, b.vn);
  ASSERT_EQ(a.fn, b.fn);
  for (int i = 0; i < a.vn; ++i) ASSERT_EQ(a.vert[i].cP(), b.vert[i].cP()) << "vertex " << i;
  for (int i = 0; i < a.fn; ++i)
    for (int k = 0; k < 3; ++k) ASSERT_EQ(vcg::tri::Index(a, a.face[i].cV(k)), vcg::tri::Index(b, b.face[i].cV(k)));
}

TEST_F(MeshIo, ply_keeps_every_attribute_in_both_precisions) {
  for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
    const MeshFile written = decorated(precision, all_of_ply);
    EXPECT_TRUE(mesh_tools::write_mesh(written, path("a.ply")).empty());
    const MeshFile read = mesh_tools::read_mesh(path("a.ply"));
    EXPECT_EQ(read.precision, precision);
    EXPECT_EQ(read.attributes & all_of_ply, all_of_ply);
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_EQ(read.mesh.textures, written.mesh.textures);
    expect_same_geometry(read.mesh, written.mesh);
    for (int i = 0; i < read.mesh.vn; ++i) {
      const auto &a = read.mesh.vert[i], &b = written.mesh.vert[i];
      ASSERT_EQ(a.cN(), b.cN());
      ASSERT_EQ(a.cC(), b.cC());
      ASSERT_EQ(a.cQ(), b.cQ());
      ASSERT_EQ(a.cR(), b.cR());
      ASSERT_EQ(a.IsS(), b.IsS());
      ASSERT_EQ(a.cT().u(), b.cT().u());
      ASSERT_EQ(a.cT().v(), b.cT().v());
    }
    for (int i = 0; i < read.mesh.fn; ++i) {
      const auto &a = read.mesh.face[i], &b = written.mesh.face[i];
      ASSERT_EQ(a.cN(), b.cN());
      ASSERT_EQ(a.cC(), b.cC());
      ASSERT_EQ(a.cQ(), b.cQ());
      ASSERT_EQ(a.IsS(), b.IsS());
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(a.cWT(k).u(), b.cWT(k).u());
        ASSERT_EQ(a.cWT(k).v(), b.cWT(k).v());
        ASSERT_EQ(a.cWT(k).n(), b.cWT(k).n());
      }
    }
    mesh_tools::write_mesh(read, path("b.ply"));
    EXPECT_EQ(bytes_of(path("a.ply")), bytes_of(path("b.ply")));
  }
}

TEST_F(MeshIo, ply_gets_no_attribute_that_the_input_did_not_have) {
  for (const int attributes : {0, int(Mask::IOM_VERTCOLOR), int(Mask::IOM_FACEFLAGS), int(Mask::IOM_VERTQUALITY)}) {
    mesh_tools::write_mesh(decorated(Precision::single_precision, attributes), path("a.ply"));
    const MeshFile read = mesh_tools::read_mesh(path("a.ply"));
    EXPECT_EQ(read.attributes & all_of_ply, attributes);
    mesh_tools::write_mesh(read, path("b.ply"));
    EXPECT_EQ(bytes_of(path("a.ply")), bytes_of(path("b.ply")));
  }
}

TEST_F(MeshIo, ply_in_text_and_big_endian_gives_the_same_mesh) {
  const std::string head =
      " 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string text = "0.1 0.2 0.3 1 2 3\n1e-30 123456.789012345678 -7 4 5 6\n1 1 1 7 8 9\n3 0 1 2\n";
  const MeshFile ascii = mesh_tools::read_mesh(write("a.ply", "ply\nformat ascii" + head + text));
  EXPECT_EQ(ascii.precision, Precision::double_precision);
  EXPECT_EQ(ascii.mesh.vert[1].cP(), vcg::Point3d(1e-30, 123456.789012345678, -7));
  EXPECT_EQ(ascii.mesh.vert[2].cC()[1], 8);
  std::string binary = "ply\nformat binary_big_endian" + head;
  const auto append = [&](const auto& value) {
    char raw[8];
    std::memcpy(raw, &value, sizeof value);
    for (std::size_t i = sizeof value; i-- > 0;) binary += raw[i];
  };
  const double coordinates[3][3] = {{0.1, 0.2, 0.3}, {1e-30, 123456.789012345678, -7}, {1, 1, 1}};
  unsigned char color = 1;
  for (const auto& place : coordinates) {
    for (const double coordinate : place) append(coordinate);
    for (int k = 0; k < 3; ++k) append(color++);
  }
  binary += '\3';
  for (const std::int32_t v : {0, 1, 2}) append(v);
  const MeshFile big = mesh_tools::read_mesh(write("b.ply", binary));
  expect_same_geometry(big.mesh, ascii.mesh);
  EXPECT_EQ(big.mesh.vert[2].cC(), ascii.mesh.vert[2].cC());
}

TEST_F(MeshIo, ply_reads_float_text_as_float) {
  const MeshFile file = mesh_tools::read_mesh(
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  EXPECT_EQ(file.precision, Precision::single_precision);
  EXPECT_EQ(file.mesh.vert[0].cP()[0], static_cast<double>(0.1f));
}

TEST_F(MeshIo, ply_names_properties_that_it_cannot_keep) {
  const MeshFile file = mesh_tools::read_mesh(
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "property float curvature\nelement face 1\nproperty list uchar int vertex_indices\n"
            "property int region\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 5\n"));
  ASSERT_EQ(file.not_kept.size(), 1u);
  EXPECT_NE(file.not_kept[0].find("vertex.curvature, face.region"), std::string::npos) << file.not_kept[0];
  EXPECT_EQ(mesh_tools::write_mesh(file, path("b.ply")), file.not_kept);
}

/// Triangle strips, as the Stanford scans have them, and a scanner's grid with a hole.
TEST_F(MeshIo, ply_reads_strips_and_range_grids) {
  const std::string head =
      "ply\nformat ascii 1.0\ncomment num_cols 2\nobj_info num_rows 2\nelement vertex 4\n"
      "property float x\nproperty float y\nproperty float z\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const auto normals = [&](const std::string& element, const std::string& data) {
    std::vector<double> z;
    for (const auto& face :
         mesh_tools::read_mesh(write("a.ply", head + element + "end_header\n" + points + data)).mesh.face)
      z.push_back(((face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0)))[2]);
    return z;
  };
  using Normals = std::vector<double>;
  const std::string strips = "element tristrips 2\nproperty list int int vertex_indices\n";
  EXPECT_EQ(normals(strips, "4 0 1 2 3\n9 0 1 2 -1 1 3 2 -1 0\n"), (Normals{1, 1, 1, 1}));
  EXPECT_EQ(normals(strips, "0\n3 -1 -1 2\n"), Normals{});
  const std::string grid = "element range_grid 4\nproperty list uchar int vertex_indices\n";
  EXPECT_EQ(normals(grid, "1 0\n1 1\n1 2\n1 3\n").size(), 2u);
}

/// Found by the fuzzer.
TEST_F(MeshIo, ply_with_a_texture_number_beyond_vcglibs_type) {
  const MeshFile file = mesh_tools::read_mesh(
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
            "property int texnumber\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1 13132000\n"));
  EXPECT_EQ(file.mesh.face[0].cWT(0).n(), 32767);
}

/// vcglib's AddFace aborts on them where assertions are on.
TEST_F(MeshIo, faces_with_a_repeated_vertex_are_read) {
  for (const auto& file : {write("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n3 0 1 2\n"),
                           write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2\nf 1 2 3\n")})
    EXPECT_EQ(mesh_tools::read_mesh(file).mesh.fn, 2) << file;
}

TEST_F(MeshIo, ply_reads_confidence_right_in_double_precision) {
  const MeshFile file = mesh_tools::read_mesh(
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
            "property float confidence\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 0.25\n1 0 0 0.5\n0 1 0 0.75\n3 0 1 2\n"));
  EXPECT_EQ(file.mesh.vert[0].cQ(), 0.25);
  EXPECT_EQ(file.mesh.vert[2].cQ(), 0.75);
}

TEST_F(MeshIo, text_formats_give_every_digit_back) {
  for (const char* name : {"a.obj", "a.off"}) {
    for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
      const MeshFile written = decorated(precision, 0);
      mesh_tools::write_mesh(written, path(name));
      expect_same_geometry(mesh_tools::read_mesh(path(name)).mesh, written.mesh);
    }
  }
}

TEST_F(MeshIo, off_keeps_normals_and_colours) {
  const int attributes = Mask::IOM_VERTNORMAL | Mask::IOM_VERTCOLOR | Mask::IOM_FACECOLOR;
  const MeshFile written = decorated(Precision::double_precision, attributes);
  EXPECT_TRUE(mesh_tools::write_mesh(written, path("a.off")).empty());
  const MeshFile read = mesh_tools::read_mesh(path("a.off"));
  EXPECT_EQ(read.attributes, attributes);
  for (int i = 0; i < read.mesh.vn; ++i) {
    ASSERT_EQ(read.mesh.vert[i].cN(), written.mesh.vert[i].cN());
    ASSERT_EQ(read.mesh.vert[i].cC(), written.mesh.vert[i].cC());
  }
  for (int i = 0; i < read.mesh.fn; ++i) ASSERT_EQ(read.mesh.face[i].cC(), written.mesh.face[i].cC());
}

TEST_F(MeshIo, obj_keeps_normals_colours_textures_and_materials) {
  const int attributes = Mask::IOM_VERTNORMAL | Mask::IOM_VERTCOLOR | Mask::IOM_FACECOLOR | Mask::IOM_WEDGTEXCOORD;
  const MeshFile written = decorated(Precision::double_precision, attributes);
  EXPECT_TRUE(mesh_tools::write_mesh(written, path("a.obj")).empty());
  EXPECT_TRUE(std::filesystem::exists(path("a.obj.mtl")));
  EXPECT_EQ(files(), 2u) << "nothing else is left in the folder";
  const MeshFile read = mesh_tools::read_mesh(path("a.obj"));
  EXPECT_EQ(read.attributes & attributes, attributes);
  expect_same_geometry(read.mesh, written.mesh);
  for (int i = 0; i < read.mesh.vn; ++i) {
    ASSERT_EQ(read.mesh.vert[i].cN(), written.mesh.vert[i].cN());
    for (int k = 0; k < 3; ++k) ASSERT_EQ(read.mesh.vert[i].cC()[k], written.mesh.vert[i].cC()[k]);
  }
  for (int i = 0; i < read.mesh.fn; ++i) {
    const auto &a = read.mesh.face[i], &b = written.mesh.face[i];
    ASSERT_EQ(a.cC(), b.cC());
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(a.cWT(k).u(), b.cWT(k).u());
      ASSERT_EQ(a.cWT(k).v(), b.cWT(k).v());
      ASSERT_EQ(read.mesh.textures.at(a.cWT(k).n()), written.mesh.textures.at(b.cWT(k).n()));
    }
  }
}

TEST_F(MeshIo, obj_takes_the_forms_of_a_face) {
  const MeshFile file = mesh_tools::read_mesh(
      write("a.obj",
            "# comment\nv 0 0 0\nv 1 0 0\r\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 3/1 4/1\n"
            "f -4//1 -3//1 -2//-1\nf 1/1/1 2/1/1 \\\n3/1/1 4/1/1\ng ignored\n"));
  ASSERT_EQ(file.mesh.fn, 5);
  const auto index = [&](int face, int k) { return vcg::tri::Index(file.mesh, file.mesh.face[face].cV(k)); };
  EXPECT_EQ(index(0, 0), 0u);
  EXPECT_EQ(index(2, 1), 1u);
  EXPECT_EQ(index(4, 0), 0u) << "polygons become fans";
  EXPECT_EQ(index(4, 1), 2u);
  EXPECT_EQ(index(4, 2), 3u);
}

TEST_F(MeshIo, obj_without_the_normals_that_its_faces_name_is_read) {
  EXPECT_EQ(mesh_tools::read_mesh(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//7 2//8 3//9\n")).mesh.fn, 1);
}

TEST_F(MeshIo, obj_without_its_material_file_says_what_is_lost) {
  const MeshFile file =
      mesh_tools::read_mesh(write("a.obj", "mtllib none.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(file.mesh.fn, 1);
  ASSERT_EQ(file.not_kept.size(), 1u);
  EXPECT_NE(file.not_kept[0].find("none.mtl"), std::string::npos) << file.not_kept[0];
}

TEST_F(MeshIo, stl_merges_the_corners_of_its_triangles) {
  const MeshFile written = decorated(Precision::single_precision, 0);
  mesh_tools::write_mesh(written, path("a.stl"));
  const MeshFile read = mesh_tools::read_mesh(path("a.stl"));
  EXPECT_EQ(read.precision, Precision::single_precision);
  EXPECT_EQ(read.mesh.vn, written.mesh.vn);
  EXPECT_EQ(read.mesh.fn, written.mesh.fn);
  for (int i = 0; i < read.mesh.fn; ++i)
    for (int k = 0; k < 3; ++k) ASSERT_EQ(read.mesh.face[i].cP(k), written.mesh.face[i].cP(k));
}

TEST_F(MeshIo, stl_keeps_face_colours_to_five_bits) {
  const MeshFile written = decorated(Precision::single_precision, Mask::IOM_FACECOLOR);
  EXPECT_TRUE(mesh_tools::write_mesh(written, path("a.stl")).empty());
  const MeshFile read = mesh_tools::read_mesh(path("a.stl"));
  EXPECT_EQ(read.attributes, Mask::IOM_FACECOLOR);
  for (int i = 0; i < read.mesh.fn; ++i)
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(read.mesh.face[i].cC()[k], written.mesh.face[i].cC()[k], 8);
}

TEST_F(MeshIo, stl_in_text_is_read) {
  const MeshFile file = mesh_tools::read_mesh(
      write("a.stl",
            "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n"
            "  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n   vertex 1 0 0\n   vertex 1 1 0\n"
            "   vertex -0.0 1 0\n  endloop\n endfacet\nendsolid a\n"));
  EXPECT_EQ(file.mesh.fn, 2);
  EXPECT_EQ(file.mesh.vn, 4) << "0 and -0 are one place";
}

TEST_F(MeshIo, stl_numbers_its_vertices_by_their_first_corners) {
  mesh_tools::Random random(3);
  using Place = std::array<float, 3>;
  // Places that many corners share, some with a zero of either sign, and then so many of one corner each that the
  // reader has to make room.
  std::vector<Place> corners;
  const auto whole = [&] { return std::floor(static_cast<float>(8 * random.uniform())); };
  for (int i = 0; i < 3000; ++i) corners.push_back({whole(), random.uniform() < 0.5 ? 0.0f : -0.0f, whole()});
  for (int i = 0; i < 30000; ++i)
    corners.push_back({static_cast<float>(random.normal()), whole(), static_cast<float>(random.uniform())});
  for (int i = 0; i < 3000; ++i) corners.push_back(corners[static_cast<std::size_t>(36000 * random.uniform()) % 33000]);

  std::string text = "solid\n";
  char line[80];
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    text += "facet\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [x, y, z] = corners[i + k];
      text.append(line, std::snprintf(line, sizeof line, "vertex %.9g %.9g %.9g\n", x, y, z));
    }
    text += "endfacet\n";
  }
  const mesh_tools::FlatMesh mesh = mesh_tools::read_flat(write("a.stl", text + "endsolid\n")).mesh;

  std::map<Place, std::uint32_t> number;  // 0 and -0 are the same key
  ASSERT_EQ(mesh.face.size(), corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [entry, is_new] = number.try_emplace(corners[i], static_cast<std::uint32_t>(number.size()));
    ASSERT_EQ(mesh.face[i / 3][i % 3], entry->second) << "corner " << i;
    for (int k = 0; is_new && k < 3; ++k) {
      const auto stored = static_cast<float>(mesh.position.number(entry->second, k));
      ASSERT_EQ(std::memcmp(&stored, &corners[i][k], sizeof stored), 0) << "corner " << i;
    }
  }
  EXPECT_EQ(mesh.vertices(), number.size());
}

TEST_F(MeshIo, formats_say_what_they_lose) {
  const MeshFile file = decorated(Precision::single_precision, all_of_ply);
  for (const char* name : {"a.obj", "a.off", "a.stl"}) {
    const auto warnings = mesh_tools::write_mesh(file, path(name));
    ASSERT_EQ(warnings.size(), 1u) << name;
    EXPECT_NE(warnings[0].find("vertex quality"), std::string::npos) << warnings[0];
  }
}

TEST_F(MeshIo, single_precision_rounds_once_and_to_nearest) {
  MeshFile file = decorated(Precision::double_precision, 0);
  file.precision = Precision::single_precision;
  mesh_tools::write_mesh(file, path("a.ply"));
  const MeshFile read = mesh_tools::read_mesh(path("a.ply"));
  for (int i = 0; i < read.mesh.vn; ++i)
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(static_cast<float>(read.mesh.vert[i].cP()[k]), static_cast<float>(file.mesh.vert[i].cP()[k]));
}

}  // namespace
