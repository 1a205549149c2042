// STL, text and binary. vcglib's reader is not used: it runs past its buffer on any header without a zero byte, and
// trusts the number of facets.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <unordered_map>

#include <mesh_tools/mesh.h>  // first: the header of vcglib below needs it

#include <vcg/complex/algorithms/update/bounding.h>

#include "formats.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

constexpr std::size_t header_size = stl_header_size, facet_size = stl_facet_size;
constexpr std::uint16_t is_color = 0x8000;  // of a facet's attribute

std::size_t facet_count(const std::string& bytes) { return (bytes.size() - header_size) / facet_size; }

struct Facet {
  vcg::Point3f corner[3];
  std::uint16_t attribute = 0;  // in binary files the colour, if its highest bit is set
};

std::vector<Facet> read_text(const std::string& bytes, const std::filesystem::path& path) {
  LineReader reader(bytes, path);
  std::vector<std::string_view> words;
  std::vector<Facet> facets;
  const auto expect = [&](const char* first, std::size_t numbers, std::size_t from) {
    if (!reader.next(words)) reader.fail("the file ends within a facet");
    if (words[0] != first || words.size() != from + numbers)
      reader.fail("'" + std::string(first) + "' with " + std::to_string(numbers) + " numbers is expected here");
  };
  while (reader.next(words)) {
    if (words[0] == "solid" || words[0] == "endsolid") continue;
    if (words[0] != "facet" || words.size() != 5) reader.fail("'facet normal' with 3 numbers is expected here");
    Facet& facet = facets.emplace_back();
    expect("outer", 0, 2);
    for (vcg::Point3f& corner : facet.corner) {
      expect("vertex", 3, 1);
      for (int k = 0; k < 3; ++k) corner[k] = static_cast<float>(reader.number(words[1 + k]));
    }
    expect("endloop", 0, 1);
    expect("endfacet", 0, 1);
  }
  return facets;
}

std::vector<Facet> read_binary(const std::string& bytes) {
  std::vector<Facet> facets(facet_count(bytes));
  const char* at = bytes.data() + header_size;
  const auto take = [&at](auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, at, sizeof value);
    if (is_big_endian_machine()) std::reverse(raw, raw + sizeof value);
    std::memcpy(&value, raw, sizeof value);
    at += sizeof value;
  };
  for (Facet& facet : facets) {
    at += 3 * sizeof(float);  // the normal, which follows from the corners
    for (vcg::Point3f& corner : facet.corner)
      for (int k = 0; k < 3; ++k) take(corner[k]);
    take(facet.attribute);
  }
  return facets;
}

/// Two programs put colours into the attribute, in opposite orders of red and blue; one of them says so in the header.
bool has_red_first(const std::string& bytes) {
  const std::string header = bytes.substr(0, 80);
  return header.find("COLOR=") != header.npos && header.find("MATERIAL=") != header.npos;
}

/// Gives faces common vertices: corners at exactly the same place become one vertex, in the order of the file.
class VertexMerger {
 public:
  std::size_t vertex_at(const vcg::Point3f& place) {
    std::array<std::uint32_t, 3> key;
    for (int k = 0; k < 3; ++k) {
      const float value = place[k] + 0.0f;  // -0 and 0 are the same place
      std::memcpy(&key[k], &value, sizeof value);
    }
    const auto [entry, is_new] = vertex_at_.try_emplace(key, places.size());
    if (is_new) places.push_back(place);
    return entry->second;
  }

  std::vector<vcg::Point3f> places;

 private:
  struct Hash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& key) const {
      std::uint64_t hash = 0;
      for (const std::uint32_t part : key) hash = (hash ^ part) * 0x9e3779b97f4a7c15u + (hash >> 29);
      return hash;
    }
  };
  std::unordered_map<std::array<std::uint32_t, 3>, std::size_t, Hash> vertex_at_;
};

void build(const std::vector<Facet>& facets, Mesh& mesh) {
  VertexMerger merger;
  std::vector<std::array<std::size_t, 3>> corners;
  corners.reserve(facets.size());
  for (const Facet& facet : facets)
    corners.push_back(
        {merger.vertex_at(facet.corner[0]), merger.vertex_at(facet.corner[1]), merger.vertex_at(facet.corner[2])});
  auto vertex = vcg::tri::Allocator<Mesh>::AddVertices(mesh, merger.places.size());
  for (const vcg::Point3f& place : merger.places) (vertex++)->P().Import(place);
  auto face = vcg::tri::Allocator<Mesh>::AddFaces(mesh, corners.size());
  for (const auto& corner : corners) {
    for (int k = 0; k < 3; ++k) face->V(k) = &mesh.vert[corner[k]];
    ++face;
  }
}

}  // namespace

bool is_binary_stl(const std::string& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() < header_size) return false;
  std::memcpy(&count, bytes.data() + header_size - sizeof count, sizeof count);
  return bytes.size() == header_size + facet_size * count;
}

MeshFile read_stl(const std::string& bytes, const std::filesystem::path& path) {
  const bool binary = is_binary_stl(bytes);
  if (!binary && (bytes.compare(0, 5, "solid") != 0 || bytes.find('\0') != std::string::npos))
    fail(path, "is neither text STL, which begins with 'solid', nor binary STL, whose size is 84 + 50 bytes a facet");
  const std::vector<Facet> facets = binary ? read_binary(bytes) : read_text(bytes, path);
  if (facets.empty()) fail(path, "holds no facets");
  MeshFile file;
  file.precision = Precision::single_precision;
  build(facets, file.mesh);
  const bool red_first = has_red_first(bytes);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const std::uint16_t attribute = facets[i].attribute;
    if (!(attribute & is_color)) continue;
    file.mesh.face[i].C() =
        red_first ? vcg::Color4b::FromUnsignedR5G5B5(attribute) : vcg::Color4b::FromUnsignedB5G5R5(attribute);
    file.attributes |= face_color;
  }
  vcg::tri::UpdateBounding<Mesh>::Box(file.mesh);
  return file;
}

std::string stl_bytes(const MeshFile& file) {
  std::string bytes = "VCG";
  bytes.resize(header_size - sizeof(std::uint32_t), ' ');
  bytes.reserve(header_size + facet_size * static_cast<std::size_t>(file.mesh.fn));
  const auto append = [&bytes](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (is_big_endian_machine()) std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
  };
  const auto append_point = [&append](const vcg::Point3d& p) {
    for (int k = 0; k < 3; ++k) append(static_cast<float>(p[k]));
  };
  append(static_cast<std::uint32_t>(file.mesh.fn));
  for (const auto& face : file.mesh.face) {
    if (face.IsD()) continue;
    append_point(vcg::TriangleNormal(face).Normalize());
    for (int k = 0; k < 3; ++k) append_point(face.cP(k));
    vcg::Color4b color = face.cC();
    const bool colored = file.attributes & face_color;
    append(static_cast<std::uint16_t>(colored ? is_color | vcg::Color4b::ToUnsignedB5G5R5(color) : 0));
  }
  return bytes;
}

}  // namespace mesh_tools::io
