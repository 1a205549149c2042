// SPDX-License-Identifier: GPL-3.0-or-later
// Files as flat arrays: what is read again for writing, and the way to vcglib's mesh and back.

#include <mesh_tools/mesh_io.h>

#include <array>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using mesh_tools::FlatFile;
using mesh_tools::SourceFile;

const std::string square =
    "ply\nformat ascii 1.0\ncomment mine\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

class FlatFiles : public tools_tests::TemporaryFolder {};

TEST_F(FlatFiles, have_the_precision_of_the_file_and_nothing_that_it_has_not) {
  FlatFile file = mesh_tools::read_flat(write("a.ply", square));
  EXPECT_NE(file.mesh.position.floats(), nullptr);
  EXPECT_EQ(file.mesh.position[2], vcg::Point3d(1, 1, 0));
  EXPECT_EQ(file.mesh.face.size(), 2u);
  EXPECT_TRUE(file.mesh.vertex_normal.empty());
  EXPECT_TRUE(file.mesh.vertex_color.empty());
  EXPECT_TRUE(file.mesh.vertex_quality.empty());
  EXPECT_TRUE(file.mesh.face_flags.empty());
}

TEST_F(FlatFiles, are_written_like_a_source_that_was_removed_or_replaced_meanwhile) {
  const fs::path input = write("a.ply", square);
  SourceFile source;
  FlatFile file = mesh_tools::read_flat(input, &source);
  fs::remove(input);
  write("a.ply", "something else");
  file.mesh.position.set(0, 2, 0.5);
  EXPECT_FALSE(source.has_changed());
  EXPECT_TRUE(mesh_tools::write_moved(file, source, input, false).empty());
  std::string expected = square;
  expected.replace(expected.find("0 0 0\n"), 5, "0 0 0.5");
  EXPECT_EQ(bytes_of(input), expected);
}

TEST_F(FlatFiles, are_written_anew_where_the_source_has_changed_in_place) {
  const fs::path input = write("a.ply", square);
  SourceFile source;
  FlatFile file = mesh_tools::read_flat(input, &source);
  std::ofstream(input, std::ios::app) << "more\n";
  EXPECT_TRUE(source.has_changed());
  const auto lost = mesh_tools::write_moved(file, source, path("b.ply"), false);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_NE(lost[0].find("has changed since it was read"), std::string::npos) << lost[0];
  const FlatFile again = mesh_tools::read_flat(path("b.ply"));
  EXPECT_EQ(again.mesh.face, file.mesh.face);
  EXPECT_EQ(again.polygons.polygons.size(), 1u);
}

TEST_F(FlatFiles, come_back_from_vcglib_without_what_was_deleted_there) {
  FlatFile flat = mesh_tools::read_flat(write("a.ply", square));
  const auto face = flat.mesh.face;
  mesh_tools::MeshFile file = mesh_tools::to_vcglib(std::move(flat));
  EXPECT_EQ(mesh_tools::to_flat(file).mesh.face, face);

  // A vertex in front that is deleted, and a triangle in front of the polygon.
  file = mesh_tools::to_vcglib(mesh_tools::read_flat(
      write("b.off", "OFF\n6 3 0\n9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n3 1 2 5\n4 1 2 3 4\n3 1 2 5\n")));
  vcg::tri::Allocator<mesh_tools::Mesh>::DeleteVertex(file.mesh, file.mesh.vert[0]);
  vcg::tri::Allocator<mesh_tools::Mesh>::DeleteFace(file.mesh, file.mesh.face[0]);
  const FlatFile back = mesh_tools::to_flat(file);
  EXPECT_EQ(back.mesh.vertices(), 5u);
  ASSERT_EQ(back.mesh.face.size(), 3u);
  EXPECT_EQ(back.mesh.face[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  ASSERT_EQ(back.polygons.polygons.size(), 1u);
  EXPECT_EQ(back.polygons.polygons[0].first_face, 0u);
  EXPECT_EQ(back.polygons.corners, (std::vector<std::uint32_t>{0, 1, 2, 5}));
}

}  // namespace
