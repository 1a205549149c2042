// SPDX-License-Identifier: GPL-3.0-or-later
// A file written in its own format is its own input, byte for byte, but for what moved.

#include <mesh_tools/mesh_io.h>

#include <cmath>
#include <cstring>
#include <map>

#include <gtest/gtest.h>
#include <mesh_tools/shapes.h>

#include "random_files.h"
#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using mesh_tools::MeshFile;
using mesh_tools::OriginalFile;
using tools_tests::Places;

class MovedFile : public tools_tests::TemporaryFolder {
 protected:
  /// Reads `input`, moves its vertices, and gives the bytes of the result.
  template <class Move>
  std::string moved(const fs::path& input, const Move& move, bool recolored = false) {
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(input, &original);
    move(file.mesh);
    const fs::path out = path("out" + input.extension().string());
    EXPECT_TRUE(mesh_tools::write_moved(file, original, out, recolored).empty()) << "nothing is lost";
    return bytes_of(out);
  }

  std::string unmoved(const fs::path& input) {
    return moved(
        input, [](mesh_tools::Mesh&) {}, true);
  }

  /// Whether a file of random layout comes back with other numbers in the right places, and none elsewhere.
  template <class Text>
  void expect_only_numbers_change(const std::string& name, const Text& text) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const Places places = tools_tests::random_places(seed, 3 + seed % 8);
      const std::string before = text(seed, Places{places.before, places.before});
      const fs::path input = write(name, before);
      ASSERT_EQ(unmoved(input), before) << "seed " << seed;
      const std::string result = moved(input, [&](mesh_tools::Mesh& mesh) {
        ASSERT_EQ(mesh.vert.size(), places.before.size());
        for (std::size_t v = 0; v < places.now.size(); ++v) {
          ASSERT_EQ(mesh.vert[v].cP(), places.before[v]);
          mesh.vert[v].P() = places.now[v];
        }
      });
      ASSERT_EQ(result, text(seed, places)) << "seed " << seed;
    }
  }
};

TEST_F(MovedFile, ply_of_any_layout_keeps_all_but_coordinates) {
  expect_only_numbers_change("a.ply", tools_tests::random_ply);
}

TEST_F(MovedFile, obj_of_any_layout_keeps_all_but_coordinates) {
  expect_only_numbers_change("a.obj", tools_tests::random_obj);
}

TEST_F(MovedFile, off_of_any_layout_keeps_all_but_coordinates) {
  expect_only_numbers_change("a.off", tools_tests::random_off);
}

TEST_F(MovedFile, stl_in_text_of_any_layout_keeps_all_but_coordinates_and_normals) {
  const auto without_normals = [](std::string text) {
    for (std::size_t at = 0; (at = text.find("normal", at)) != text.npos; ++at)
      text.erase(at + 6, text.find_first_of("\r\n", at) - at - 6);
    return text;
  };
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Places places = tools_tests::random_places(seed, 3 + seed % 8);
    const std::string before = tools_tests::random_stl(seed, {places.before, places.before});
    const fs::path input = write("a.stl", before);
    ASSERT_EQ(unmoved(input), before) << "seed " << seed;
    const std::string result = moved(input, [&](mesh_tools::Mesh& mesh) {
      for (auto& vertex : mesh.vert)
        for (std::size_t v = 0; v < places.before.size(); ++v)
          if (places.before[v] == vertex.P()) {
            vertex.P() = places.now[v];
            break;
          }
    });
    ASSERT_EQ(without_normals(result), without_normals(tools_tests::random_stl(seed, places))) << "seed " << seed;
  }
}

/// A closed mesh, written by this library.
MeshFile sphere(mesh_tools::Precision precision) {
  MeshFile file;
  file.mesh = mesh_tools::make_shape("sphere", 200);
  file.precision = precision;
  return file;
}

TEST_F(MovedFile, stl_in_binary_keeps_its_header_its_attributes_and_the_normals_of_facets_that_stay) {
  mesh_tools::write_mesh(sphere(mesh_tools::Precision::single_precision), path("a.stl"));
  std::string bytes = bytes_of(path("a.stl"));
  const std::size_t facets = (bytes.size() - 84) / 50;
  bytes.replace(0, 30, "EPSG:25832 COLOR= MATERIAL=\x01\x02\x03");
  for (std::size_t f = 0; f < facets; ++f) {
    const float normal[3] = {9, -0.0f, 9};
    std::memcpy(&bytes[84 + 50 * f], normal, sizeof normal);
    bytes[84 + 50 * f + 48] = static_cast<char>(f);
  }
  const fs::path input = write("b.stl", bytes);
  EXPECT_EQ(unmoved(input), bytes);
  vcg::Point3d away(2, 0, 0), place;
  const std::string result = moved(input, [&](mesh_tools::Mesh& mesh) {
    place = mesh.vert[7].cP();
    mesh.vert[7].P() += away;
  });
  ASSERT_EQ(result.size(), bytes.size());
  EXPECT_EQ(result.substr(0, 84), bytes.substr(0, 84));
  std::size_t changed = 0;
  for (std::size_t f = 0; f < facets; ++f) {
    float was[12], is[12];
    std::memcpy(was, &bytes[84 + 50 * f], sizeof was);
    std::memcpy(is, &result[84 + 50 * f], sizeof is);
    EXPECT_EQ(result[84 + 50 * f + 48], static_cast<char>(f));
    bool has_vertex = false;
    vcg::Point3d corner[3];
    for (int c = 0; c < 3; ++c) {
      const vcg::Point3d old(was[3 + 3 * c], was[4 + 3 * c], was[5 + 3 * c]);
      corner[c] = {is[3 + 3 * c], is[4 + 3 * c], is[5 + 3 * c]};
      has_vertex |= old == place;
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(is[3 + 3 * c + k], static_cast<float>(old[k] + (old == place ? away[k] : 0)));
    }
    if (!has_vertex) {
      EXPECT_EQ(std::memcmp(was, is, sizeof was), 0);
      continue;
    }
    ++changed;
    const vcg::Point3d normal = ((corner[1] - corner[0]) ^ (corner[2] - corner[0])).Normalize();
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(is[k], normal[k], 1e-6);
  }
  EXPECT_GE(changed, 3u) << "every facet at the vertex";
}

TEST_F(MovedFile, files_of_this_library_come_back_as_they_were) {
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"})
    for (const auto precision : {mesh_tools::Precision::single_precision, mesh_tools::Precision::double_precision}) {
      MeshFile file = sphere(precision);
      file.attributes = mesh_tools::normal_attributes | mesh_tools::vertex_color_attribute;
      mesh_tools::update_normals(file.mesh);
      mesh_tools::write_mesh(file, path(name));
      EXPECT_EQ(unmoved(path(name)), bytes_of(path(name))) << name;
    }
}

TEST_F(MovedFile, another_format_is_written_anew_and_what_is_lost_is_named) {
  OriginalFile original;
  MeshFile file = mesh_tools::read_mesh(
      write("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "property float age\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"),
      &original);
  const auto lost = mesh_tools::write_moved(file, original, path("b.obj"), false);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_NE(lost[0].find("vertex.age"), std::string::npos) << lost[0];
  EXPECT_EQ(bytes_of(path("b.obj")), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

TEST_F(MovedFile, structure_that_another_format_loses_is_named) {
  const auto lost = [&](const char* name, const std::string& bytes) {
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(write(name, bytes), &original);
    std::string all;
    for (const std::string& sentence : mesh_tools::write_moved(file, original, path("out.stl"), false))
      all += sentence.substr(sentence.find(": ") + 2) + "\n";
    return all;
  };
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  EXPECT_EQ(lost("a.obj", corners + "f 1 2 3\n"), "");
  EXPECT_EQ(lost("a.obj", corners + "s 1\ng a\ng b\nf 1 2 3 4\nf 1 2 3\n"),
            "these statements are not kept: g, s\n1 polygon was cut into triangles\n");
  EXPECT_EQ(lost("a.obj", corners + "vn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\n"),
            "normals per corner become normals per vertex\n"
            "the format cannot hold these attributes, they are left out: vertex normals\n");
  EXPECT_EQ(lost("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n4 3 2 1 0\n"),
            "2 polygons were cut into triangles\n");
  EXPECT_EQ(lost("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 "
                 "1 2 3\n"),
            "1 polygon was cut into triangles\n");
}

TEST_F(MovedFile, bytes_that_do_not_fit_the_mesh_are_refused_and_leave_nothing) {
  const std::map<std::string, std::pair<std::string, std::string>> cases = {
      {"a.obj", {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nf 1 2 3\n"}},
      {"b.obj",
       {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nvn 0 0 1\nf 1//1 4//1 9//9\n"}},
      {"a.off", {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF\n2 1 0\n0 0 0\n1 0 0\n"}},
      {"b.off", {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF\n3 1 0\n0 0 0\n1 0 0\n"}},
      {"a.stl",
       {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid\n",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n"}},
      {"b.stl",
       {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid\n",
        std::string(84, ' ').replace(80, 4, 4, '\0')}},
      {"a.ply",
       {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n",
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n"}}};
  for (const auto& [name, text] : cases) {
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(write(name, text.first), &original);
    original.bytes = text.second;
    const std::size_t before = files();
    const fs::path out = path("out" + path(name).extension().string());
    EXPECT_THROW(mesh_tools::write_moved(file, original, out, false), mesh_tools::FileError) << name;
    EXPECT_EQ(files(), before) << name;
  }
}

TEST_F(MovedFile, colours_and_qualities_follow_on_request) {
  const auto recolor = [](mesh_tools::Mesh& mesh) {
    mesh.vert[1].C() = vcg::Color4b(1, 2, 51, 255);
    mesh.vert[1].Q() = 0.25;
  };
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nproperty float "
      "red2\nend_header\n";
  const fs::path ply = write("a.ply", head + "0 0 0 7 007 7 0.10 5\n1 0 0 7 002 7 0.10 5\n0 1 0 7 7 7 0.10 5\n");
  EXPECT_EQ(moved(ply, recolor, true), head + "0 0 0 7 007 7 0.10 5\n1 0 0 1 002 51 0.25 5\n0 1 0 7 7 7 0.10 5\n");
  EXPECT_EQ(moved(ply, recolor, false), bytes_of(ply));
  const fs::path obj = write("a.obj", "v 0 0 0 .5 .5 .50\nv 1 0 0 1 .5 .50\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(moved(obj, recolor, true),
            "v 0 0 0 .5 .5 .50\nv 1 0 0 0.00392156862745098 0.00784313725490196 0.2\nv 0 1 0\nf 1 2 3\n");
  const fs::path whole = write("b.obj", "v 0 0 0 1 1 1\nv 1 0 0 0 2. 0\nv 0 1 0 9 9 9\nf 1 2 3\n");
  EXPECT_EQ(moved(whole, recolor, true), "v 0 0 0 1 1 1\nv 1 0 0 1 2. 51\nv 0 1 0 9 9 9\nf 1 2 3\n");
  const fs::path off = write("a.off", "COFF\n3 1 0\n0 0 0 7 7 7\n1 0 0 7 2 7\n0 1 0 .5 .5 .5\n3 0 1 2\n");
  EXPECT_EQ(moved(off, recolor, true), "COFF\n3 1 0\n0 0 0 7 7 7\n1 0 0 1 2 51\n0 1 0 .5 .5 .5\n3 0 1 2\n");
}

TEST_F(MovedFile, materials_are_found_from_another_folder) {
  fs::create_directories(path("in/sub"));
  fs::create_directories(path("out/deep"));
  for (const char* name : {"in/a.mtl", "in/b.mtl", "in/two words.mtl", "in/sub/c.mtl", "out/d.mtl"})
    write(name, "newmtl m\n");
  const auto names = [&](const std::string& given, const char* out) {
    OriginalFile original;
    MeshFile file = mesh_tools::read_mesh(
        write("in/a.obj", "mtllib " + given + "\r\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), &original);
    mesh_tools::write_moved(file, original, path(out), false);
    const std::string text = bytes_of(path(out));
    EXPECT_EQ(text.substr(text.find('\r')), original.bytes.substr(original.bytes.find('\r')));
    return text.substr(7, text.find('\r') - 7);
  };
  EXPECT_EQ(names("a.mtl", "in/b.obj"), "a.mtl");
  EXPECT_EQ(names("none such.mtl", "in/b.obj"), "none such.mtl");
  EXPECT_EQ(names("a.mtl", "out/b.obj"), "../in/a.mtl");
  EXPECT_EQ(names("sub\\c.mtl", "out/deep/b.obj"), "../../in/sub/c.mtl");
  EXPECT_EQ(names("../out/d.mtl", "out/b.obj"), "d.mtl");
  EXPECT_EQ(names("two words.mtl", "out/b.obj"), "../in/two words.mtl");
  EXPECT_EQ(names("a.mtl  b.mtl", "out/b.obj"), "../in/a.mtl  ../in/b.mtl");
  EXPECT_EQ(names("missing.mtl", "out/b.obj"), "../in/missing.mtl");
  EXPECT_EQ(names("/elsewhere/a.mtl", "out/b.obj"), "/elsewhere/a.mtl");
  EXPECT_FALSE(fs::exists(path("out/b.obj.mtl"))) << "the materials are those that the file names";
}

TEST_F(MovedFile, a_comment_that_ends_in_a_backslash_hides_no_line) {
  const MeshFile file = mesh_tools::read_mesh(
      write("a.obj", "# made from C:\\models\\\nv 0 0 0\nv 1 \\\n 0 0\nv 0 1 0 # here \\\nf 1 \\\n2 3\n"));
  EXPECT_EQ(file.mesh.vn, 3);
  EXPECT_EQ(file.mesh.fn, 1);
}

}  // namespace
