// STL: vcglib reads and writes it, after and before a check of our own.

#include <array>
#include <cstring>
#include <unordered_map>

#include <mesh_tools/mesh.h>  // these two first: the headers of vcglib below need them
#include <wrap/io_trimesh/io_mask.h>

#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/update/bounding.h>
#include <wrap/io_trimesh/export_stl.h>
#include <wrap/io_trimesh/import_stl.h>

#include "formats.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

std::size_t facet_count(const std::string& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= header_size) std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

bool is_binary(const std::string& bytes) {
  return bytes.size() >= header_size && bytes.size() == header_size + facet_size * facet_count(bytes);
}

/// Throws unless the text is what vcglib's reader takes for granted; returns the number of facets.
std::size_t check_text(const std::string& bytes, const std::filesystem::path& path) {
  LineReader reader(bytes, path);
  std::vector<std::string_view> words;
  std::size_t facets = 0;
  const auto expect = [&](const char* first, std::size_t numbers, std::size_t from) {
    if (!reader.next(words)) reader.fail("the file ends within a facet");
    if (words[0] != first || words.size() != from + numbers)
      reader.fail("'" + std::string(first) + "' with " + std::to_string(numbers) + " numbers is expected here");
    for (std::size_t k = from; k < words.size(); ++k) reader.number(words[k]);
  };
  while (reader.next(words)) {
    if (words[0] == "solid" || words[0] == "endsolid") continue;
    if (words[0] != "facet" || words.size() != 5) reader.fail("'facet normal' with 3 numbers is expected here");
    expect("outer", 0, 2);
    for (int k = 0; k < 3; ++k) expect("vertex", 3, 1);
    expect("endloop", 0, 1);
    expect("endfacet", 0, 1);
    ++facets;
  }
  return facets;
}

/// Gives faces common vertices: those at exactly the same place become one, the first in the file.
void merge_vertices(MeshF& mesh) {
  struct Hash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& key) const {
      std::uint64_t hash = 0;
      for (std::uint32_t part : key) hash = (hash ^ part) * 0x9e3779b97f4a7c15u + (hash >> 29);
      return hash;
    }
  };
  std::unordered_map<std::array<std::uint32_t, 3>, MeshF::VertexPointer, Hash> first_at;
  first_at.reserve(mesh.vert.size());
  std::vector<MeshF::VertexPointer> merged(mesh.vert.size());
  for (auto& vertex : mesh.vert) {
    std::array<std::uint32_t, 3> key;
    for (int k = 0; k < 3; ++k) {
      const float value = vertex.P()[k] + 0.0f;  // -0 and 0 are the same place
      std::memcpy(&key[k], &value, sizeof value);
    }
    merged[vcg::tri::Index(mesh, vertex)] = first_at.try_emplace(key, &vertex).first->second;
  }
  for (auto& face : mesh.face)
    for (int k = 0; k < 3; ++k) face.V(k) = merged[vcg::tri::Index(mesh, face.V(k))];
  for (std::size_t i = 0; i < merged.size(); ++i)
    if (merged[i] != &mesh.vert[i]) vcg::tri::Allocator<MeshF>::DeleteVertex(mesh, mesh.vert[i]);
}

}  // namespace

MeshFile read_stl(const std::filesystem::path& path) {
  std::size_t facets = 0;
  {
    const std::string bytes = read_bytes(path);
    if (is_binary(bytes)) {
      facets = facet_count(bytes);
    } else {
      if (bytes.compare(0, 5, "solid") != 0 || bytes.find('\0') != std::string::npos)
        fail(path,
             "is neither text STL, which begins with 'solid', nor binary STL, whose size is 84 + 50 bytes a facet");
      facets = check_text(bytes, path);
    }
  }
  if (facets == 0) fail(path, "holds no facets");
  MeshF mesh;
  MeshFile file;
  file.precision = Precision::single_precision;
  int mask = vcg::tri::io::Mask::IOM_FACECOLOR;
  const int error = vcg::tri::io::ImporterSTL<MeshF>::Open(mesh, path.c_str(), mask);
  if (error != 0) fail(path, std::string("cannot be read: ") + vcg::tri::io::ImporterSTL<MeshF>::ErrorMsg(error));
  if (mesh.face.size() != facets)
    fail(path,
         "has " + std::to_string(facets) + " facets, of which " + std::to_string(mesh.face.size()) + " were read");
  file.attributes = mask & face_color;
  merge_vertices(mesh);
  convert(mesh, file.mesh);
  vcg::tri::UpdateBounding<Mesh>::Box(file.mesh);
  return file;
}

bool write_stl(const MeshFile& file, const std::filesystem::path& path) {
  MeshF mesh;
  convert(file.mesh, mesh);
  const int mask = file.attributes & face_color;
  if (vcg::tri::io::ExporterSTL<MeshF>::Save(mesh, path.c_str(), true, mask) != 0) return false;
  std::error_code error;
  return std::filesystem::file_size(path, error) == header_size + facet_size * mesh.face.size();
}

}  // namespace mesh_tools::io
