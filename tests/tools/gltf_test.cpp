// SPDX-License-Identifier: GPL-3.0-or-later
// GLB and glTF: triangles out of buffers, and other numbers back into them.

#include <mesh_tools/mesh_io.h>

#include <cmath>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/gltf/base64.h"
#include "io/gltf/json_places.h"
#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using mesh_tools::FileError;
using mesh_tools::MeshFile;
using mesh_tools::OriginalFile;
using vcg::Point3d;

template <class Number>
std::string raw(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// A tetrahedron: positions and normals one by one, three bytes of nothing, and indices of 16 bits.
const std::vector<float> places = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1};
const std::vector<std::uint16_t> corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
std::string buffer() { return raw(places) + "..." + std::string(1, '\0') + raw(corners); }

/// What programs write in many ways: spaces, the order of members, members that nobody knows.
const std::string text = R"({ "asset" : {"version":"2.0", "extras": "a \"name\" of ] { things"},
  "scene":0, "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0 NODE}],
  "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"material":0}]}],
  "accessors":[
    {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3", "min":[0.0,0,0E0],"max":[1.0, 1, 1.00]},
    {"bufferView":0,"byteOffset":12,"componentType":5126,"count":4,"type":"VEC3"},
    {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR","min":[0],"max":[3]}],
  "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96,"byteStride":24},
                 {"buffer":0,"byteOffset":100,"byteLength":24}],
  "materials":[{"name":"wood"}],"images":[{"uri":"pictures/a%20wood.png"}],
  "buffers":[{"byteLength":124 URI}]}
)";

std::string replaced(std::string where, const std::string& what, const std::string& by) {
  const std::size_t at = where.find(what);
  EXPECT_NE(at, where.npos) << what;
  return at == where.npos ? where : where.replace(at, what.size(), by);
}

std::string json(const std::string& uri, const std::string& node = "") {
  return replaced(replaced(text, " NODE", node), " URI", uri.empty() ? "" : ", \"uri\":\"" + uri + "\"");
}

std::string glb(std::string content, std::string binary) {
  content.resize((content.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto number = [](std::size_t value) {
    return raw(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)});
  };
  const std::string tail = number(4) + "more" + "1234";  // a chunk that nobody knows
  return "glTF" + number(2) + number(28 + content.size() + binary.size() + tail.size()) + number(content.size()) +
         "JSON" + content + number(binary.size()) + std::string("BIN\0", 4) + binary + tail;
}

class Gltf : public tools_tests::TemporaryFolder {
 protected:
  MeshFile read(const fs::path& input) { return mesh_tools::read_mesh(input, &original_); }

  void expect_tetrahedron(const MeshFile& file) {
    ASSERT_EQ(file.mesh.vn, 4);
    ASSERT_EQ(file.mesh.fn, 4);
    EXPECT_EQ(file.mesh.vert[2].cP(), Point3d(0, 1, 0));
    EXPECT_EQ(file.precision, mesh_tools::Precision::single_precision);
    double volume = 0;
    for (const auto& face : file.mesh.face) volume += face.cP(0) * (face.cP(1) ^ face.cP(2)) / 6;
    EXPECT_NEAR(volume, 1.0 / 6, 1e-12);
  }

  /// Written without a change: the same bytes. Then one vertex moves.
  std::string moved(const fs::path& input, const fs::path& out, const std::function<void(mesh_tools::Mesh&)>& move) {
    MeshFile file = read(input);
    EXPECT_TRUE(mesh_tools::write_moved(file, original_, path("same" + input.extension().string()), false).empty());
    EXPECT_EQ(bytes_of(path("same" + input.extension().string())), original_.bytes);
    move(file.mesh);
    EXPECT_TRUE(mesh_tools::write_moved(file, original_, out, false).empty());
    return bytes_of(out);
  }

  static void move_one(mesh_tools::Mesh& mesh) { mesh.vert[1].P() = Point3d(1.5, -0.25, 0); }

  void expect_refused(const std::string& content, const std::string& says) {
    try {
      mesh_tools::read_mesh(write("a.gltf", content));
      ADD_FAILURE() << says;
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("a.gltf"), std::string::npos) << error.what();
    }
  }

  OriginalFile original_;
};

TEST_F(Gltf, base64_goes_both_ways) {
  using mesh_tools::io::from_base64;
  using mesh_tools::io::to_base64;
  const std::pair<const char*, const char*> known[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};  // RFC 4648
  for (const auto& [bytes, base64] : known) {
    EXPECT_EQ(to_base64(bytes), base64);
    EXPECT_EQ(from_base64(base64), std::string(bytes));
  }
  EXPECT_EQ(from_base64("Zm9v!"), std::nullopt);
}

TEST_F(Gltf, values_are_found_in_json) {
  using namespace mesh_tools::io;
  const std::string object = R"( {"a" : [1 ,{"b":"]}\"" }, -2.5e3],"c":null , "a":"last", "d":{}})";
  const std::string_view value = json_value(object, 0);
  EXPECT_EQ(json_member(value, "a"), "\"last\"");
  EXPECT_EQ(json_member(value, "c"), "null");
  EXPECT_EQ(json_member(value, "d"), "{}");
  EXPECT_EQ(json_member(value, "b"), "");
  std::vector<std::string_view> elements;
  visit_elements(R"([1 ,{"b":"]}\"" }, -2.5e3])",
                 [&](std::size_t, std::string_view part) { elements.push_back(part); });
  EXPECT_EQ(elements, (std::vector<std::string_view>{"1", R"({"b":"]}\"" })", "-2.5e3"}));
  for (const std::string cut : {"{\"a", "{\"a\":", "{\"a\":[", "[", "[1,", "{\"a\\"})
    EXPECT_EQ(json_member(cut, "b"), "");
}

TEST_F(Gltf, glb_gets_other_numbers_and_nothing_else) {
  const std::string before = glb(json(""), buffer());
  const fs::path input = write("a.glb", before);
  expect_tetrahedron(read(input));
  const std::string after = moved(input, path("b.glb"), move_one);
  const std::string head = replaced(replaced(json(""), "[0.0,0,", "[0.0,-0.25,"), "[1.0, 1", "[1.5, 1");
  std::vector<float> now = places;
  now[6] = 1.5f;
  now[7] = -0.25f;
  // All but the normals, for which there is another test.
  std::string without_normals = after, expected = glb(head, replaced(buffer(), raw(places), raw(now)));
  ASSERT_EQ(after.size(), expected.size());
  const std::size_t binary = expected.find(raw(now));
  for (std::size_t v = 0; v < 4; ++v)
    for (std::string* bytes : {&without_normals, &expected}) bytes->replace(binary + 24 * v + 12, 12, 12, 'n');
  EXPECT_EQ(without_normals, expected);
  EXPECT_EQ(mesh_tools::read_mesh(path("b.glb")).mesh.vert[1].cP(), Point3d(1.5, -0.25, 0));
}

TEST_F(Gltf, normals_follow) {
  const fs::path input = write("a.glb", glb(json(""), buffer()));
  moved(input, path("b.glb"), move_one);
  MeshFile file = mesh_tools::read_mesh(path("b.glb"));
  ASSERT_TRUE(file.attributes & mesh_tools::normal_attributes);
  std::vector<Point3d> found;
  for (const auto& vertex : file.mesh.vert) found.push_back(vertex.cN());
  mesh_tools::update_normals(file.mesh);
  for (std::size_t v = 0; v < 4; ++v) EXPECT_LT((found[v] - file.mesh.vert[v].cN()).Norm(), 1e-6);
}

TEST_F(Gltf, buffers_in_the_text) {
  const std::string prefix = "data:application/octet-stream;base64,";
  const std::string before = json(prefix + mesh_tools::io::to_base64(buffer()));
  const fs::path input = write("a.gltf", before);
  expect_tetrahedron(read(input));
  moved(input, path("b.gltf"), move_one);
  const MeshFile after = mesh_tools::read_mesh(path("b.gltf"));
  EXPECT_EQ(after.mesh.vert[1].cP(), Point3d(1.5, -0.25, 0));
  EXPECT_EQ(bytes_of(path("b.gltf")).size(), before.size() + 4) << "-0.25 for 0";
}

TEST_F(Gltf, buffers_in_files) {
  write("a b.bin", buffer());
  const fs::path input = write("a.gltf", json("a%20b.bin"));
  expect_tetrahedron(read(input));
  moved(input, path("b.gltf"), move_one);
  EXPECT_EQ(bytes_of(path("a b.bin")), buffer()) << "others may use it";
  EXPECT_NE(bytes_of(path("b.gltf")).find("\"uri\":\"b.gltf.bin\""), std::string::npos);
  EXPECT_EQ(mesh_tools::read_mesh(path("b.gltf")).mesh.vert[1].cP(), Point3d(1.5, -0.25, 0));
  EXPECT_EQ(mesh_tools::files_of(path("b.gltf")).back(), path("b.gltf.bin"));
  // Over itself.
  MeshFile file = read(input);
  move_one(file.mesh);
  mesh_tools::write_moved(file, original_, input, false);
  EXPECT_EQ(bytes_of(path("a b.bin")).substr(24, 4), raw(std::vector<float>{1.5f}));
  EXPECT_EQ(mesh_tools::read_mesh(input).mesh.vert[1].cP(), Point3d(1.5, -0.25, 0));
}

TEST_F(Gltf, names_of_files_follow_into_another_folder) {
  fs::create_directories(path("in/pictures"));
  fs::create_directories(path("out"));
  write("in/a.bin", buffer());
  write("in/pictures/a wood.png", "a picture");
  const fs::path input = write("in/a.gltf", json("a.bin"));
  MeshFile file = read(input);
  mesh_tools::write_moved(file, original_, path("out/a.gltf"), false);
  const std::string names = replaced(json("../in/a.bin"), "pictures/a%20wood.png", "../in/pictures/a%20wood.png");
  EXPECT_EQ(bytes_of(path("out/a.gltf")), names);
  move_one(file.mesh);
  mesh_tools::write_moved(file, original_, path("out/a.gltf"), false);
  EXPECT_NE(bytes_of(path("out/a.gltf")).find("a.gltf.bin"), std::string::npos);
  EXPECT_EQ(bytes_of(path("in/a.bin")), buffer());
}

/// Smoothing happens in the world, where parts of one thing fit together.
TEST_F(Gltf, nodes_put_meshes_into_the_world) {
  const std::pair<std::string, Point3d> nodes[] = {
      {", \"translation\":[5,6,7]", {6, 6, 7}},
      {", \"scale\":[2,3,4],\"translation\":[5,6,7]", {7, 6, 7}},
      {", \"rotation\":[0,0,0.7071067811865476,0.7071067811865476]", {0, 1, 0}},
      {", \"matrix\":[0,2,0,0, -2,0,0,0, 0,0,2,0, 1,1,1,1]", {1, 3, 1}},
      {", \"scale\":[-1,1,1]", {-1, 0, 0}}};
  for (const auto& [node, expected] : nodes) {
    const fs::path input = write("a.glb", glb(json("", node), buffer()));
    const MeshFile file = read(input);
    EXPECT_LT((file.mesh.vert[1].cP() - expected).Norm(), 1e-12) << node;
    double volume = 0;
    for (const auto& face : file.mesh.face)
      volume += (face.cP(0) - expected) * ((face.cP(1) - expected) ^ (face.cP(2) - expected)) / 6;
    EXPECT_GT(volume, 0) << "faces show outwards: " << node;
    moved(input, path("b.glb"), [](mesh_tools::Mesh& mesh) { mesh.vert[1].P() += Point3d(0.5, 0.25, 0.125); });
    const MeshFile after = mesh_tools::read_mesh(path("b.glb"));
    EXPECT_LT((after.mesh.vert[1].cP() - expected - Point3d(0.5, 0.25, 0.125)).Norm(), 1e-6) << node;
    for (const int v : {0, 2, 3}) EXPECT_EQ(after.mesh.vert[v].cP(), file.mesh.vert[v].cP());
  }
}

TEST_F(Gltf, strips_fans_and_no_indices) {
  const auto faces = [&](const std::string& mode) {
    const std::string part = R"("indices":2,"material":0)";
    const MeshFile file = read(write("a.glb", glb(replaced(json(""), part, mode), buffer())));
    std::vector<std::vector<std::size_t>> result;
    for (const auto& face : file.mesh.face)
      result.push_back({vcg::tri::Index(file.mesh, face.cV(0)), vcg::tri::Index(file.mesh, face.cV(1)),
                        vcg::tri::Index(file.mesh, face.cV(2))});
    return result;
  };
  using Faces = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(faces(R"("mode":4)"), (Faces{{0, 1, 2}}));
  EXPECT_EQ(faces(R"("mode":5)"), (Faces{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(faces(R"("mode":6)"), (Faces{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(Gltf, what_cannot_be_changed_in_place_is_refused_by_name) {
  const std::string sound = json("data:;base64," + mesh_tools::io::to_base64(buffer()));
  expect_tetrahedron(mesh_tools::read_mesh(write("a.gltf", sound)));
  const std::string primitive = R"("indices":2,"material":0)";
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"})
    expect_refused(replaced(sound, "\"scene\":0", "\"extensionsRequired\":[\"" + std::string(name) + "\"]"), name);
  expect_refused(replaced(sound, primitive, primitive + R"(,"extensions":{"KHR_draco_mesh_compression":{}})"),
                 "mesh 0, primitive 0: is compressed by KHR_draco_mesh_compression");
  expect_refused(
      replaced(sound, R"("byteStride":24)", R"("byteStride":24,"extensions":{"EXT_meshopt_compression":{}})"),
      "EXT_meshopt_compression");
  expect_refused(replaced(sound, primitive, primitive + R"(,"targets":[{"POSITION":0}])"), "morph targets");
  expect_refused(replaced(sound, R"("min":[0.0)", R"("sparse":{},"min":[0.0)"), "positions are sparse");
  expect_refused(replaced(sound, "5126", "5122"), "KHR_mesh_quantization");
  EXPECT_THROW(mesh_tools::write_mesh(mesh_tools::read_mesh(path("a.gltf")), path("b.gltf")), FileError);
  EXPECT_THROW(mesh_tools::check_writable(path("b.glb")), FileError);
  EXPECT_THROW(mesh_tools::check_writable(path("b.glb"), path("a.gltf")), FileError);
  EXPECT_NO_THROW(mesh_tools::check_writable(path("b.glb"), path("a.GLB")));
}

TEST_F(Gltf, files_that_lie) {
  const std::string sound = json("data:;base64," + mesh_tools::io::to_base64(buffer()));
  expect_refused("{", "holds no sound JSON");
  expect_refused("{}", "holds no triangles");
  expect_refused(replaced(sound, "\"byteStride\":24", "\"byteStride\":40"), "go beyond the end of their buffer");
  expect_refused(replaced(sound, "\"byteStride\":24", "\"byteStride\":4"), "go beyond the end of their buffer");
  expect_refused(replaced(sound, "\"count\":4", "\"count\":4000000000"), "go beyond the end of their buffer");
  expect_refused(replaced(sound, "\"count\":4", "\"count\":3"), "index 5 is 3; there are 3 positions");
  expect_refused(replaced(sound, "\"count\":4", "\"count\":-4"), "count is no whole number");
  expect_refused(replaced(sound, "\"byteOffset\":100", "\"byteOffset\":1e3"), "byteOffset is no whole number");
  expect_refused(replaced(sound, "\"byteOffset\":100", "\"byteOffset\":18446744073709551615"), "no whole number");
  expect_refused(replaced(sound, "\"POSITION\":0", "\"POSITION\":9"), "refers to accessors 9; there are 3");
  expect_refused(replaced(sound, "{\"mesh\":0", "{\"mesh\":0, \"children\":[7]"), "has a child that is not there");
  expect_refused(replaced(sound, "{\"mesh\":0", "{\"mesh\":0, \"scale\":[0,1,1]"), "is made flat");
  expect_refused(replaced(sound, "base64,AAAA", "base64,?AAA"), "buffer 0 cannot be used: is a data URI without sound");
  expect_refused(json("none.bin"), "none.bin: cannot be read");
  expect_refused(json("https://example.org/a.bin"), "only files beside this one are read");
  // A node that is its own child is reached from nowhere.
  expect_tetrahedron(mesh_tools::read_mesh(
      write("a.gltf", replaced(sound, "{\"mesh\":0", "{\"mesh\":0, \"children\":[0], \"translation\":[1,1,1]"))));
  const std::string whole = glb(json(""), buffer());
  for (std::size_t size = 1; size < whole.size(); size += 7)
    EXPECT_THROW(mesh_tools::read_mesh(write("a.glb", whole.substr(0, size))), FileError) << size;
}

TEST_F(Gltf, goes_into_other_formats) {
  MeshFile file = read(write("a.glb", glb(json(""), buffer())));
  const auto lost = mesh_tools::write_moved(file, original_, path("a.ply"), false);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_NE(lost[0].find("of glTF only triangles and normals are kept"), std::string::npos);
  expect_tetrahedron(mesh_tools::read_mesh(path("a.ply")));
}

}  // namespace
