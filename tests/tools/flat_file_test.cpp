// SPDX-License-Identifier: GPL-3.0-or-later
// Files as flat arrays: what is read again for writing, and the way to vcglib's mesh and back.

#include <mesh_tools/mesh_io.h>

#include <array>
#include <cstdint>
#include <filesystem>
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

/// Binary STL of this many facets, each with a colour of its own, and some bytes behind them.
std::string colored_stl(std::uint32_t facets, const std::string& title) {
  std::string bytes = title;
  bytes.resize(80, ' ');
  const auto append = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(facets);
  for (std::uint32_t f = 0; f < facets; ++f) {
    const auto x = static_cast<float>(f);
    for (const float number : {0.f, 0.f, 1.f, x, 0.f, 0.f, x + 1, 0.f, 0.f, x, 1.f, 0.f}) append(number);
    append(static_cast<std::uint16_t>(f % 0x7fff + (f + 1 == facets ? 0x8000 : 0)));  // marked is the last one only
  }
  return bytes + "behind";
}

TEST_F(FlatFiles, of_binary_stl_that_are_read_in_parts_are_those_read_at_once) {
  for (const char* title : {"parts", "solid, which makes readers look for text"}) {
    const fs::path input = write("large.stl", colored_stl(20000, title));
    SourceFile source;
    FlatFile parts = mesh_tools::read_flat(input, &source);
    mesh_tools::OriginalFile original;
    mesh_tools::MeshFile at_once = mesh_tools::read_mesh(input, &original);
    const FlatFile flat = mesh_tools::to_flat(at_once);
    EXPECT_EQ(parts.mesh.face, flat.mesh.face);
    ASSERT_EQ(parts.mesh.face_color.size(), 20000u);
    EXPECT_EQ(parts.mesh.face_color[0], vcg::Color4b(255, 255, 255, 255));
    EXPECT_EQ(parts.mesh.face_color[19999], vcg::Color4b::FromUnsignedB5G5R5(19999));
    mesh_tools::write_moved(parts, source, path("same.stl"), false);
    EXPECT_EQ(bytes_of(path("same.stl")), bytes_of(input));

    for (const std::size_t v : {std::size_t(5), parts.mesh.vertices() - 1}) {
      parts.mesh.position.set(v, {-1, 2, 3});
      at_once.mesh.vert[v].P() = {-1, 2, 3};
    }
    mesh_tools::write_moved(parts, source, path("parts.stl"), false);
    mesh_tools::write_moved(at_once, std::move(original), path("at_once.stl"), false);
    EXPECT_EQ(bytes_of(path("parts.stl")), bytes_of(path("at_once.stl")));
    EXPECT_NE(bytes_of(path("parts.stl")), bytes_of(input));
  }
}

TEST_F(FlatFiles, that_no_longer_fit_their_source_leave_nothing_behind) {
  const fs::path input = write("large.stl", colored_stl(20000, "parts"));
  SourceFile source;
  FlatFile file = mesh_tools::read_flat(input, &source);
  file.mesh.face.pop_back();
  EXPECT_THROW(mesh_tools::write_moved(file, source, path("out.stl"), false), mesh_tools::FileError);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(input.parent_path())) ++files;
  EXPECT_EQ(files, 1u);
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
