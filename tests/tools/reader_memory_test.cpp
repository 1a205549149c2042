// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of meshes allocate for files whose headers lie, and how their work grows with the file.

#include <mesh_tools/mesh_io.h>

#include <algorithm>
#include <ctime>
#include <string>

#include <gtest/gtest.h>
#include <support/allocation_peak.h>

#include "temporary_folder.h"

namespace {

class ReaderMemory : public tools_tests::TemporaryFolder {
 protected:
  /// The most memory at one time, in multiples of the file's size, that refusing it takes.
  double refusal_of(const std::filesystem::path& file) const {
    const double size = static_cast<double>(std::filesystem::file_size(file));
    const test_support::AllocationPeak peak;
    EXPECT_THROW(mesh_tools::read_mesh(file), mesh_tools::FileError) << file;
    return static_cast<double>(peak.bytes()) / size;
  }
};

constexpr std::size_t megabyte = 1 << 20;

std::string ply_head(const std::string& format, std::size_t vertices, const std::string& coordinate) {
  std::string head = "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) + "\n";
  for (const char* name : {"x", "y", "z"}) head.append("property ").append(coordinate).append(" ").append(name) += "\n";
  return head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

/// In memory a vertex takes 80 bytes, in a file no fewer than 12 as floats, 24 as doubles, 6 as text: more than the
/// bytes of the file can hold is never asked for.
TEST_F(ReaderMemory, a_header_that_lies_about_vertices_gets_no_more_than_the_file_holds) {
  const std::string binary(megabyte, '\0');
  EXPECT_LT(refusal_of(write("a.ply", ply_head("binary_little_endian", megabyte, "float") + binary)), 1.2 + 80.0 / 12);
  EXPECT_LT(refusal_of(write("b.ply", ply_head("binary_big_endian", megabyte, "double") + binary)), 1.2 + 80.0 / 24);
  std::string text;
  while (text.size() < megabyte) text += "0 0 0\n";
  EXPECT_LT(refusal_of(write("c.ply", ply_head("ascii", megabyte, "float") + text)), 1.2 + 80.0 / 6);
  EXPECT_LT(refusal_of(write("d.off", "OFF\n" + std::to_string(megabyte / 2) + " 1 0\n" + text)), 1.2);
}

TEST_F(ReaderMemory, a_list_that_lies_about_its_length_gets_nothing) {
  const std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uint int vertex_indices\nend_header\n" +
      std::string(36, '\0');
  const std::string count = {0, 0, 15, 0};  // 983040 corners: each takes four bytes, of which there are too few
  EXPECT_LT(refusal_of(write("list.ply", head + count + std::string(megabyte, '\0'))), 1.2);
}

/// An honest header may ask for all that the file holds.
TEST_F(ReaderMemory, counts_that_fill_the_file_are_read) {
  const std::string faces = "\3" + std::string({0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0});
  const auto binary =
      write("full.ply", ply_head("binary_little_endian", 1000, "float") + std::string(12000, '\0') + faces);
  EXPECT_EQ(mesh_tools::read_mesh(binary).mesh.vn, 1000);
  std::string text = ply_head("ascii", 1000, "float");
  for (int i = 0; i < 1000; ++i) text += "0 0 0\n";
  EXPECT_EQ(mesh_tools::read_mesh(write("full_text.ply", text + "3 0 1 2")).mesh.vn, 1000);
  EXPECT_EQ(mesh_tools::read_mesh(write("full.off", "OFF 3 0 0\n0 0 0\n0 0 0\n0 0 0")).mesh.vn, 3);
  EXPECT_EQ(mesh_tools::read_mesh(write("face.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2")).mesh.fn, 1);
}

/// An OBJ file with a material and a texture of its own for each face.
class ManyMaterials : public tools_tests::TemporaryFolder {
 protected:
  std::filesystem::path obj(std::size_t materials) const {
    const std::string name = std::to_string(materials);
    std::string mesh = "mtllib " + name + ".mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", library;
    for (std::size_t i = 0; i < materials; ++i) {
      const std::string number = std::to_string(i);
      library.append("newmtl m").append(number).append("\nKd 0 0 1\nmap_Kd t").append(number).append(".png\n");
      mesh.append("usemtl m").append(number).append("\nf 1 2 3\n");
    }
    write(name + ".mtl", library);
    return write(name + ".obj", mesh);
  }

  /// Processor time of reading; the least of a few runs.
  static double clocks(const std::filesystem::path& file, int runs) {
    double least = 1e300;
    for (int run = 0; run < runs; ++run) {
      const std::clock_t start = std::clock();
      (void)mesh_tools::read_mesh(file);
      least = std::min(least, static_cast<double>(std::clock() - start));
    }
    return least;
  }
};

/// Sixteen times as many took sixteen times sixteen as long when each `usemtl` and `map_Kd` walked through all names.
TEST_F(ManyMaterials, are_read_in_time_that_follows_their_number) {
  const auto few = obj(2000), many = obj(32000);
  EXPECT_LT(clocks(many, 2), 60 * clocks(few, 5));
}

TEST_F(ManyMaterials, are_each_their_own) {
  const mesh_tools::MeshFile file = mesh_tools::read_mesh(obj(3));
  EXPECT_EQ(file.mesh.textures, (std::vector<std::string>{"t0.png", "t1.png", "t2.png"}));
  EXPECT_EQ(file.mesh.face[0].cC(), vcg::Color4b(0, 0, 255, 255));
}

TEST_F(ManyMaterials, of_several_with_one_name_the_last_counts) {
  write("a.mtl", "newmtl m\nKd 1 0 0\nnewmtl n\nKd 0 1 0\nnewmtl m\nKd 0 0 1\n");
  const auto file =
      write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\nusemtl none\nf 1 2 3\n");
  const mesh_tools::MeshFile read = mesh_tools::read_mesh(file);
  EXPECT_EQ(read.mesh.face[0].cC(), vcg::Color4b(0, 0, 255, 255));
  EXPECT_EQ(read.mesh.face[1].cC(), vcg::Color4b(255, 255, 255, 255));
}

}  // namespace
