// SPDX-License-Identifier: GPL-3.0-or-later
// make_seeds FOLDER: the inputs that the fuzzers begin with, a folder for each of them: files as our writers and other
// programs make them, meshes with one defect each.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

#include <mesh_tools/mesh_io.h>
#include <mesh_tools/shapes.h>

#include "core_case.h"

namespace {

namespace fs = std::filesystem;
using fuzz::CoreCase;

class Seeds {
 public:
  Seeds(fs::path folder, std::string extension) : folder_(std::move(folder)), extension_(std::move(extension)) {
    fs::create_directories(folder_);
  }

  fs::path next() { return folder_ / (std::to_string(count_++) + extension_); }
  void add(const std::string& bytes) { std::ofstream(next(), std::ios::binary) << bytes; }

 private:
  fs::path folder_;
  std::string extension_;
  int count_ = 0;
};

mesh_tools::MeshFile small_cube(mesh_tools::Precision precision) {
  mesh_tools::MeshFile file;
  file.mesh = mesh_tools::make_shape("cube", 8);
  file.precision = precision;
  return file;
}

/// What our own writers make: plain, and with every attribute that they know.
void add_written(Seeds& seeds) {
  for (const auto precision : {mesh_tools::Precision::single_precision, mesh_tools::Precision::double_precision}) {
    mesh_tools::MeshFile file = small_cube(precision);
    mesh_tools::write_mesh(file, seeds.next());
    file.mesh.textures.emplace_back("first.png");
    file.mesh.textures.emplace_back("second.png");
    file.attributes = 0xfffff;
    mesh_tools::write_mesh(file, seeds.next());
  }
}

const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string ply_head(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment TextureFile a.png\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
}

std::string ply_values(bool big_endian, std::size_t size, double value) {
  std::string bytes;
  const auto whole = static_cast<std::uint32_t>(value);
  const auto real = static_cast<float>(value);
  std::uint32_t bits = whole;
  if (size == 0) std::memcpy(&bits, &real, sizeof bits);
  const std::size_t count = size == 0 ? 4 : size;
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(bits >> (8 * (big_endian ? count - 1 - i : i)));
  return bytes;
}

void add_ply(Seeds& seeds) {
  const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
  seeds.add(ply_head("ascii") + faces + "end_header\n" + vertices + "4 0 1 2 3\n3 0 1 2\n");
  seeds.add(ply_head("ascii") + "property uchar red\nproperty float quality\nproperty list uchar int more\n" + faces +
            "property uchar flags\nend_header\n" + "0 0 0 9 .5 0\n1 0 0 9 .5 1 7\n1 1 0 9 .5 2 7 8\n0 1 0 9 nan 0\n" +
            "3 0 1 2 32\n3 0 2 3 0\n");
  seeds.add(ply_head("ascii") + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + vertices +
            "5 0 1 2 3 -1\n");
  seeds.add(ply_head("ascii") + faces + "property list uchar float texcoord\nproperty int texnumber\n" +
            "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" + vertices +
            "3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 0 0\n0 2\n");
  for (const bool big_endian : {false, true}) {
    std::string text = ply_head(big_endian ? "binary_big_endian" : "binary_little_endian") + faces + "end_header\n";
    for (const double value : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) text += ply_values(big_endian, 0, value);
    text += '\4';
    for (const double value : {0, 1, 2, 3}) text += ply_values(big_endian, 4, value);
    text += '\3';
    for (const double value : {0, 1, 2}) text += ply_values(big_endian, 4, value);
    seeds.add(text);
  }
}

void add_obj(Seeds& seeds) {
  const std::string four = "v 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 0\n";
  seeds.add("# text\nmtllib none.mtl\n" + four + "vt 0 0\nvt 1 1\nvn 0 0 1\nusemtl red\nf 1/1/1 2/2/1 3/1/1\n" +
            "f 1//1 3//1 4//1\nl 1 2 3\n");
  seeds.add(four + "f -4 -3 \\\n -2 -1\ng part\ns off\n");
}

void add_off(Seeds& seeds) {
  seeds.add("OFF\n4 2 0\n" + vertices + "3 0 1 2 255 0 0\n4 0 1 2 3 0.5 0.5 0.5 1\n");
  seeds.add("STCNOFF 3 1 0\n0 0 0 0 0 1 9 9 9 9 0 0\n1 0 0 0 0 1 9 9 9 9 0 0\n0 1 0 0 0 1 9 9 9 9 0 0\n3 0 1 2\n");
}

void add_stl(Seeds& seeds) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 -0\nendloop\nendfacet\n";
  seeds.add("solid name\n" + facet + facet + "endsolid name\n");
}

/// A triangle; `rest` follows the members that it needs.
std::string gltf(const std::string& uri, const std::string& rest) {
  return R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":0}}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36)" +
         uri + "}]" + rest + "}";
}

const std::string gltf_node = R"(,"nodes":[{"children":[1],"scale":[2,2,2]},{"mesh":0,"translation":[1,2,3]}])";

void add_gltf(Seeds& seeds) {
  const std::string uri = R"(,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA")";
  seeds.add(gltf(uri, ""));
  seeds.add(gltf(uri, gltf_node + R"(,"images":[{"uri":"a.png"}])"));
}

void add_glb(Seeds& seeds) {
  for (const std::string& rest : {std::string(), gltf_node}) {
    std::string text = gltf("", rest);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const float places[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const auto number = [](std::size_t value) {
      std::string bytes;
      for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k));
      return bytes;
    };
    seeds.add("glTF" + number(2) + number(28 + text.size() + sizeof places) + number(text.size()) + "JSON" + text +
              number(sizeof places) + std::string("BIN\0", 4) +
              std::string(reinterpret_cast<const char*>(places), sizeof places));
  }
}

/// A bent grid of 25 vertices, every method and precision.
CoreCase grid(const vcg_core::MethodInfo& method, bool double_precision) {
  constexpr int n = 5;
  CoreCase result;
  result.method = method.method;
  result.parameters = method.defaults;
  result.double_precision = double_precision;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      result.vertices.push_back({float(x), float(y), 0.2F * float((7 * x + 5 * y) % 4), std::uint8_t(0)});
  for (int y = 0; y + 1 < n; ++y)
    for (int x = 0; x + 1 < n; ++x) {
      const auto a = static_cast<std::uint8_t>(n * y + x);
      const auto at = [&](int offset) { return static_cast<std::uint8_t>(a + offset); };
      result.faces.push_back({{a, at(1), at(n + 1)}, 0});
      result.faces.push_back({{a, at(n + 1), at(n)}, 0});
    }
  return result;
}

void add_core(Seeds& seeds) {
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) {
    for (const bool double_precision : {false, true}) seeds.add(grid(method, double_precision).encode());
    const auto add = [&](const auto& change) {
      CoreCase seed = grid(method, true);
      seed.parameters.boundary = vcg_core::Boundary::free;
      change(seed);
      seeds.add(seed.encode());
    };
    add([](CoreCase& c) { c.parameters.arithmetic = vcg_core::Arithmetic::reference; });
    add([](CoreCase& c) { c.parameters.iterations = 3; });
    add([](CoreCase& c) { c.parameters.smooth_color = true; });
    add([](CoreCase& c) { c.parameters.sigma_c = c.parameters.rho = 1e300; });
    add([](CoreCase& c) { c.parameters.sigma_s = c.parameters.sigma_n = 1e-300; });
    add([](CoreCase& c) { c.parameters.rho = std::numeric_limits<double>::quiet_NaN(); });
    add([](CoreCase& c) { c.parameters.gaussian = vcg_core::GaussianForm::printed; });
    add([](CoreCase& c) { c.cancel_at = 2; });
    add([](CoreCase& c) { c.vertices[12].x = std::numeric_limits<float>::infinity(); });
    add([](CoreCase& c) { c.vertices[12].z = 1e30F; });
    add([](CoreCase& c) { c.vertices[12] = c.vertices[13]; });
    add([](CoreCase& c) { c.faces[5].corner[0] = 25; });
    add([](CoreCase& c) { c.faces[5].corner[0] = c.faces[5].corner[1]; });
    add([](CoreCase& c) { c.faces.push_back(c.faces[5]); });
    add([](CoreCase& c) { c.faces[7].flags = CoreCase::deleted; });
    add([](CoreCase& c) {
      c.parameters.selected_only = true;
      c.faces[7].flags = CoreCase::selected;
    });
    add([](CoreCase& c) {
      for (CoreCase::Vertex& v : c.vertices) v = {v.x * 1e-30F, v.y * 1e-30F, v.z * 1e-30F, v.flags};
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_seeds FOLDER\n";
    return 2;
  }
  const fs::path folder = argv[1];
  Seeds core(folder / "core", "");
  add_core(core);
  const auto add_format = [&](const std::string& format, void (*add)(Seeds&)) {
    Seeds seeds(folder / format, "." + format);
    add_written(seeds);
    add(seeds);
  };
  add_format("ply", add_ply);
  add_format("obj", add_obj);
  add_format("off", add_off);
  add_format("stl", add_stl);
  // These are not written anew.
  Seeds glb(folder / "glb", ".glb"), text(folder / "gltf", ".gltf");
  add_glb(glb);
  add_gltf(text);
  return 0;
}
