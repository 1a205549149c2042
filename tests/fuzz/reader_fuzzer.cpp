// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes in a file of one format (FUZZED_EXTENSION): refused in one line that names the file, or a mesh whose faces
// refer to its vertices, and that is the same after it was written and read again. Written as what it was read from, it
// is the same bytes as long as nothing moved, and then a file of the moved mesh.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>

#include <mesh_tools/mesh_io.h>

#include "require.h"

namespace {

using mesh_tools::Mesh;
using mesh_tools::MeshFile;

/// A folder of this process, for the file that the readers want; removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "fuzz_XXXXXX").string();
    FUZZ_REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  std::filesystem::path file(const char* stem) const { return path_ / (std::string(stem) + FUZZED_EXTENSION); }

 private:
  std::filesystem::path path_;
};

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void require_valid(const Mesh& mesh) {
  FUZZ_REQUIRE(mesh.vn > 0 && static_cast<std::size_t>(mesh.vn) == mesh.vert.size());
  FUZZ_REQUIRE(static_cast<std::size_t>(mesh.fn) == mesh.face.size());
  const std::less<> before;
  for (const auto& face : mesh.face)
    for (int k = 0; k < 3; ++k)
      FUZZ_REQUIRE(!before(face.cV(k), mesh.vert.data()) && before(face.cV(k), mesh.vert.data() + mesh.vert.size()));
}

void require_same(const Mesh& a, const Mesh& b, bool corners_too = true) {
  FUZZ_REQUIRE(a.vn == b.vn && a.fn == b.fn);
  for (std::size_t v = 0; v < a.vert.size(); ++v)
    for (int k = 0; k < 3; ++k) FUZZ_REQUIRE(is_same(a.vert[v].cP()[k], b.vert[v].cP()[k]));
  for (std::size_t f = 0; f < a.face.size() && corners_too; ++f)
    for (int k = 0; k < 3; ++k)
      FUZZ_REQUIRE(vcg::tri::Index(a, a.face[f].cV(k)) == vcg::tri::Index(b, b.face[f].cV(k)));
}

/// STL joins vertices by their place: those that are not a number, and those of no facet, are not found again.
constexpr bool is_gltf = std::string_view(FUZZED_EXTENSION).substr(0, 2) == ".g";
/// Of glTF, vertices go through transforms.
constexpr bool keeps_vertices = std::string_view(FUZZED_EXTENSION) != ".stl" && !is_gltf;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void require_kept(MeshFile& file, const mesh_tools::OriginalFile& original, const std::filesystem::path& output) {
  mesh_tools::write_moved(file, original, output, false);
  FUZZ_REQUIRE(bytes_of(output) == original.bytes);
  for (auto& vertex : file.mesh.vert)
    for (int k = 0; k < 3; ++k) {
      const double place = 1 - vertex.cP()[k];
      vertex.P()[k] = file.precision == mesh_tools::Precision::single_precision ? static_cast<float>(place) : place;
    }
  mesh_tools::write_moved(file, original, output, true);
  const MeshFile again = mesh_tools::read_mesh(output);
  require_valid(again.mesh);
  // Where a polygon's corners have moved, it may be cut otherwise.
  FUZZ_REQUIRE(!is_gltf || file.mesh.vn == again.mesh.vn);
  if (keeps_vertices) require_same(file.mesh, again.mesh, file.polygons.polygons.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  static const std::filesystem::path input = folder.file("in"), output = folder.file("out");
  std::ofstream(input, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  MeshFile file;
  mesh_tools::OriginalFile original;
  try {
    file = mesh_tools::read_mesh(input, &original);
  } catch (const mesh_tools::FileError& error) {
    const std::string message = error.what();
    FUZZ_REQUIRE(message.find(input.string()) != std::string::npos);
    FUZZ_REQUIRE(message.find('\n') == std::string::npos);
    return 0;
  }
  require_valid(file.mesh);
  if (!is_gltf) {  // which is not written anew
    mesh_tools::write_mesh(file, output);
    const MeshFile again = mesh_tools::read_mesh(output);
    require_valid(again.mesh);
    if (keeps_vertices) require_same(file.mesh, again.mesh);
  }
  require_kept(file, original, output);
  return 0;
}
