// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/mesh_io.h>

#include <sys/resource.h>

#include <csignal>

#include <gtest/gtest.h>
#include <mesh_tools/shapes.h>

#include "temporary_folder.h"

namespace {

using mesh_tools::FileError;
using mesh_tools::MeshFile;

class MeshIoErrors : public tools_tests::TemporaryFolder {
 protected:
  /// Reading must fail with one line that names the file and contains `what`.
  void expect_error(const std::filesystem::path& file, const std::string& what) {
    try {
      mesh_tools::read_mesh(file);
      ADD_FAILURE() << file << " must be refused: " << what;
    } catch (const FileError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(file.string()), std::string::npos) << message;
      EXPECT_NE(message.find(what), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }

  static MeshFile cube() {
    MeshFile file;
    file.mesh = mesh_tools::make_shape("cube", 100);
    return file;
  }
};

const std::string ply_head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string three_vertices = "0 0 0\n1 0 0\n0 1 0\n";

TEST_F(MeshIoErrors, files_that_cannot_be_read) {
  expect_error(path("none.ply"), "does not exist");
  expect_error(write("mesh.xyz", "0 0 0\n"), "allowed are .ply, .obj, .off, .stl, .glb and .gltf");
  expect_error(write("mesh", "0 0 0\n"), "has no extension");
  std::filesystem::create_directory(path("folder.ply"));
  expect_error(path("folder.ply"), "is a folder");
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"}) expect_error(write(name, ""), "is empty");
}

TEST_F(MeshIoErrors, ply_that_is_none) {
  expect_error(write("a.ply", "OFF\n3 1 0\n"), "not a PLY file");
  expect_error(write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), "end_header");
  expect_error(write("a.ply", "ply\nformat middle_endian 1.0\nend_header\n"), "unknown format 'middle_endian'");
  expect_error(write("a.ply", "ply\nformat ascii 1.0\nelment vertex 3\nend_header\n"), "line 3: unknown word 'elment'");
  expect_error(
      write("a.ply", "ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"),
      "declares no vertices");
  expect_error(write("a.ply", "ply\nformat ascii 1.0\nelement vertex many\nend_header\n"), "'many' is not a count");
}

TEST_F(MeshIoErrors, ply_that_is_cut_off_or_wrong_inside) {
  expect_error(write("a.ply", ply_head + "0 0 0\n1 0 0\n"), "ends within vertex 2 of 3");
  expect_error(write("a.ply", ply_head + three_vertices), "ends within face 0 of 1");
  expect_error(write("a.ply", ply_head + three_vertices + "3 0 1 3\n"), "vertex index");
  expect_error(write("a.ply", ply_head + three_vertices + "3 0 1 -1\n"), "vertex index");
  expect_error(write("a.ply", ply_head + three_vertices + "2 0 3\n"), "vertex index 3");
  expect_error(write("a.ply", ply_head + "0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n"), "'zero' is not a number");
}

TEST_F(MeshIoErrors, ply_whose_binary_data_are_cut_off) {
  mesh_tools::write_mesh(cube(), path("whole.ply"));
  const std::string whole = bytes_of(path("whole.ply"));
  for (const double part : {0.5, 0.9})
    expect_error(write("a.ply", whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size())))),
                 "cut off");
  expect_error(write("a.ply", whole.substr(0, whole.size() - 1)), "cut off");
}

TEST_F(MeshIoErrors, ply_with_too_many_texture_coordinates) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n" +
      three_vertices + "3 0 1 2 40";
  for (int i = 0; i < 40; ++i) text += " 0.5";
  expect_error(write("a.ply", text + "\n"), "has 40 texture coordinates; allowed are 6");
}

/// What vcglib's importer takes on trust.
TEST_F(MeshIoErrors, ply_with_indices_out_of_range) {
  const std::string head =
      "ply\nformat ascii 1.0\ncomment num_cols 2\ncomment num_rows 2\nelement vertex 3\n"
      "property float x\nproperty float y\nproperty float z\n";
  const auto expect = [&](const std::string& element, const std::string& data, const std::string& what) {
    expect_error(write("a.ply", head + element + "end_header\n" + three_vertices + data), what);
  };
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  for (const char* last : {"3", "-1", "2147483647"})
    expect(faces, std::string("4 0 1 2 ") + last, "face 0 has vertex index " + std::string(last));
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  for (const char* strip : {"3 0 1 3", "3 0 3 1", "3 0 -2 1", "5 0 -1 0 1 9"})
    expect(strips, strip, "tristrips 0 has vertex index ");
  const std::string edges = "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
  expect(edges, "0 3", "edge 0 has vertex index 3");
  const std::string grid = "property list uchar int vertex_indices\n";
  expect("element range_grid 4\n" + grid, "1 0 1 1 1 3 0", "range_grid 2 has vertex index 3");
  expect("element range_grid 5\n" + grid, "1 0 1 1 1 2 0 0", "num_cols times num_rows");
}

TEST_F(MeshIoErrors, ply_with_numbers_that_do_not_fit) {
  for (const char* corner : {"2.0", "0x2", "2x", "99999999999", "1e0", "nan", ""})
    expect_error(write("a.ply", ply_head + three_vertices + "3 0 1 " + corner + "\n"), "face 0");
  expect_error(write("a.ply", ply_head + three_vertices + "300 0 1 2\n"), "'300'");
  expect_error(write("a.ply", ply_head + three_vertices + "-1 0 1 2\n"), "'-1'");
  expect_error(write("a.ply", ply_head + "0 0 0x\n1 0 0\n0 1 0\n3 0 1 2\n"), "vertex 0");
}

TEST_F(MeshIoErrors, ply_whose_header_promises_too_much) {
  const std::string vertex = "property float x\nproperty float y\nproperty float z\n";
  const auto expect = [&](const std::string& lines, const std::string& what) {
    expect_error(write("a.ply", "ply\nformat ascii 1.0\n" + lines + "end_header\n" + three_vertices), what);
  };
  expect("element vertex 2147483647\n" + vertex, "is cut off");
  expect("element vertex 4294967296\n" + vertex, "is not a count");
  expect("element vertex 3\n" + vertex + "element face 2147483647\nproperty list uchar int vertex_indices\n",
         "is cut off");
  expect("element vertex 3\n" + vertex + "element nothing 2147483647\n", "without any property");
  expect("element vertex 3\n" + vertex + "element vertex 3\n" + vertex, "declared twice");
  expect("element vertex 3\n" + vertex + "property float x\n", "declared twice");
  expect("element vertex 3\n" + vertex + "element face 1\nproperty int material\n", "without 'vertex_indices'");
  expect("element vertex\a 3\n" + vertex, "needs a name");
}

TEST_F(MeshIoErrors, words_of_a_file_are_cut_short_in_messages) {
  expect_error(write("a.obj", "v 0 0 " + std::string(100000, 'x') + "\n"), std::string(40, 'x') + "...'");
  expect_error(write("a.off", "OFF\n1 0 0\n0 0 \x1b[31m\n"), "'?[31m' is not a number");
}

TEST_F(MeshIoErrors, ply_with_vertices_of_an_unknown_kind) {
  expect_error(
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property list uchar float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                three_vertices + "3 0 1 2\n"),
      "vertex property 'z' must be there and be a number");
}

TEST_F(MeshIoErrors, obj_names_the_line) {
  expect_error(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n"), "line 5: refers to vertex 4");
  expect_error(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), "line 4: refers to vertex 0");
  expect_error(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n"), "line 4: refers to vertex -4");
  expect_error(write("a.obj", "f 1 2 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"), "line 1: refers to vertex 4; the file has 3");
  expect_error(write("a.obj", "v 0 0 0\nvt 0 0\nf 1/1 1/1 1/3\nvt 1 0\n"),
               "line 3: refers to texture coordinate 3; the file has 2");
  expect_error(write("a.obj", "v 0 0 0\nvt\n"), "line 2: a texture coordinate has no numbers");
  expect_error(write("a.obj", "v 0 0\n"), "line 1: a vertex has fewer than 3 numbers");
  expect_error(write("a.obj", "v 0 0 1x\n"), "'1x' is not a number");
  expect_error(write("a.obj", "# nothing\n"), "holds no vertices");
}

TEST_F(MeshIoErrors, off_names_the_line) {
  expect_error(write("a.off", "3 1 0\n"), "must begin with the word OFF");
  expect_error(write("a.off", "4OFF\n3 1 0\n"), "allowed prefixes");
  expect_error(write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"), "ends before its 3 vertices");
  expect_error(write("a.off", "OFF\n3 1 0\n" + three_vertices), "ends before its 1 faces");
  expect_error(write("a.off", "OFF\n3 1 0\n" + three_vertices + "3 0 1 3\n"), "line 6: a face refers to vertex 3");
  expect_error(write("a.off", "OFF\n3 1 0\n" + three_vertices + "3 0 1 -1\n"), "allowed are 0 to 2");
  expect_error(write("a.off", "OFF\n3 1 0\n" + three_vertices + "2 0 3\n"), "line 6: a face refers to vertex 3");
  expect_error(write("a.off", "OFF\n3 1 0\n" + three_vertices + "-3 0 1 2\n"), "line 6: a face has -3 corners");
  expect_error(write("a.off", "OFF\n3 1 0\n" + three_vertices + "4 0 1 2\n"), "fewer vertices than it says");
  expect_error(write("a.off", "OFF\n-3 1 0\n"), "a count is negative");
  expect_error(write("a.off", "OFF\n2000000000 1 0\n0 0 0\n"), "exceed the file");
}

TEST_F(MeshIoErrors, stl_that_is_none) {
  expect_error(write("a.stl", "nonsense"), "neither text STL");
  expect_error(write("a.stl", "solid a\nendsolid a\n"), "holds no facets");
  expect_error(write("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\n"),
               "line 5: 'vertex' with 3 numbers");
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  expect_error(write("a.stl", "solid a\n" + facet + "endloop\nendfacet\n"),
               "line 7: a facet has fewer than 3 vertices");
  expect_error(write("a.stl", "solid a\n" + facet + "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"),
               "line 7: a facet has more than 3 vertices");
  expect_error(write("a.stl", "solid a\n" + facet), "the file ends within a facet");
  expect_error(write("a.stl", "solid a\n" + facet + facet), "line 6: 'vertex' with 3 numbers, or the end");
  expect_error(write("a.stl", "solid a\nvertex 0 0 0\n"), "line 2: 'facet' is expected here");
  mesh_tools::write_mesh(cube(), path("whole.stl"));
  const std::string whole = bytes_of(path("whole.stl"));
  expect_error(write("a.stl", whole.substr(0, whole.size() - 1)), "neither text STL");
}

TEST_F(MeshIoErrors, places_that_cannot_be_written) {
  const auto expect_refused = [&](const std::filesystem::path& file, const std::string& what) {
    try {
      mesh_tools::check_writable(file);
      ADD_FAILURE() << file;
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
    EXPECT_THROW(mesh_tools::write_mesh(cube(), file), FileError);
  };
  expect_refused(path("none") / "a.ply", "there is no folder");
  expect_refused(path("a.3ds"), "unknown extension '.3ds'");
  std::filesystem::create_directory(path("folder.ply"));
  expect_refused(path("folder.ply"), "not a regular file");
  EXPECT_EQ(files(), 1u) << "nothing was left behind";
}

TEST_F(MeshIoErrors, an_interrupted_writer_leaves_the_old_file_alone) {
  const auto file = write("a.ply", "precious");
  EXPECT_THROW(mesh_tools::write_mesh(cube(), file, [] { return true; }), mesh_tools::WriteInterrupted);
  EXPECT_EQ(bytes_of(file), "precious");
  EXPECT_EQ(files(), 1u);
}

TEST_F(MeshIoErrors, a_file_that_is_replaced_keeps_its_permissions_and_links) {
  namespace fs = std::filesystem;
  const auto file = write("a.ply", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.ply", path("link.ply"));
  mesh_tools::write_mesh(cube(), path("link.ply"));
  EXPECT_TRUE(fs::is_symlink(path("link.ply")));
  EXPECT_NE(bytes_of(file), "old");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files(), 2u);
}

/// As on a full disk: the system takes no more bytes.
TEST_F(MeshIoErrors, a_full_disk_is_noticed) {
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {1000, before.rlim_max};
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.off"}) {
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    bool refused = false;
    try {
      mesh_tools::write_mesh(cube(), path(name));
    } catch (const FileError&) {
      refused = true;
    }
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_TRUE(refused) << name;
    EXPECT_EQ(files(), 0u) << name;
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(MeshIoErrors, a_link_whose_target_is_not_there_stays_a_link) {
  namespace fs = std::filesystem;
  fs::create_directory(path("deep"));
  fs::create_symlink("deep/a.ply", path("link.ply"));
  mesh_tools::write_mesh(cube(), path("link.ply"));
  EXPECT_TRUE(fs::is_symlink(path("link.ply")));
  EXPECT_EQ(mesh_tools::read_mesh(path("deep/a.ply")).mesh.vn, cube().mesh.vn);
  fs::create_symlink("none/a.ply", path("lost.ply"));
  EXPECT_THROW(mesh_tools::check_writable(path("lost.ply")), FileError);
}

}  // namespace
