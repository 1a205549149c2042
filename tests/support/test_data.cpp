// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/test_data.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_support {

namespace {

std::filesystem::path data_folder() {
  const char* const from_environment = std::getenv("ANISO_TEST_DATA");
  return from_environment != nullptr ? from_environment : ANISO_TEST_DATA;
}

/// An OBJ file of triangles: `v x y z` and `f a b c` or `f a/... b/... c/...` only.
std::optional<FlatMesh> read_obj(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return std::nullopt;
  FlatMesh mesh;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Point p;
      words >> p[0] >> p[1] >> p[2];
      mesh.points.push_back(p);
    } else if (kind == "f") {
      Triangle f;
      for (std::size_t& v : f) {
        std::string word;
        words >> word;
        v = std::stoul(word) - 1;
      }
      mesh.faces.push_back(f);
    }
  }
  return mesh;
}

}  // namespace

std::vector<std::string> model_names() { return {"Fandisk0.3", "Block0.4", "SharpSphere0.3", "Bunny0.2"}; }

std::optional<ModelPair> load_model(const std::string& name) {
  const std::filesystem::path folder = data_folder() / name;
  std::optional<FlatMesh> noisy = read_obj(folder / "noisy.obj");
  std::optional<FlatMesh> original = read_obj(folder / "original.obj");
  if (!noisy || !original) return std::nullopt;
  return ModelPair{std::move(*noisy), std::move(*original)};
}

}  // namespace test_support
