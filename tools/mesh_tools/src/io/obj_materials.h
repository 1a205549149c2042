// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <vcg/space/color4.h>

namespace mesh_tools::io {

/// What OBJ files say by their material files, as far as meshes can hold it: colour, opacity, texture of colour.
class ObjMaterials {
 public:
  struct Material {
    std::string name;
    vcg::Color4b color{255, 255, 255, 255};
    int page = -1;  ///< index into textures(); -1: none
  };

  /// @param folder  of the OBJ file
  explicit ObjMaterials(const std::filesystem::path& folder) : folder_(folder) {}

  /// Takes a mtllib statement. It may name several files, or one whose name holds spaces: the file system tells.
  void add_libraries(const std::vector<std::string_view>& words);

  /// What a usemtl statement names: index for material(), -1 if there is no such material.
  int find(const std::vector<std::string_view>& words) const;

  const Material& material(int index) const { return materials_[static_cast<std::size_t>(index)]; }

  /// Names of texture files, from the OBJ file's folder, in the order in which they come first.
  std::vector<std::string>& textures() { return textures_; }

  /// What cannot be read, in sentences.
  std::vector<std::string> problems;

 private:
  void add_library(const std::filesystem::path& name);
  void read_library(const std::filesystem::path& name);
  int page_of(const std::string& name);

  std::filesystem::path folder_;
  std::vector<Material> materials_;
  std::unordered_map<std::string, int> material_of_;  // of several with one name the last counts
  std::vector<std::string> textures_;
  std::unordered_map<std::string, int> page_of_;
};

}  // namespace mesh_tools::io
