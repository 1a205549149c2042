// SPDX-License-Identifier: GPL-3.0-or-later
// STL, text and binary. vcglib's reader is not used: it runs past its buffer on any header without a zero byte, and
// trusts the number of facets.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <unordered_map>

#include <mesh_tools/mesh.h>  // first: the header of vcglib below needs it

#include <vcg/complex/algorithms/update/bounding.h>

#include "formats.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

constexpr std::size_t header_size = stl_header_size, facet_size = stl_facet_size;
constexpr std::uint16_t color_bit = 0x8000;  // of a facet's attribute

struct Facet {
  vcg::Point3f corner[3];
  std::uint16_t attribute = 0;  // of binary files
};

/// Programs write keywords in small letters or capitals, put words behind them, leave normals out. So what counts are
/// the vertices, and that there are three between the facet's beginning and end.
std::vector<Facet> read_text(const std::string& bytes, const std::filesystem::path& path) {
  LineReader reader(bytes, path);
  std::vector<std::string_view> words;
  std::vector<Facet> facets;
  std::size_t corners = 0;
  bool in_facet = false;
  while (reader.next(words)) {
    const StlKeyword keyword = stl_keyword(words[0]);
    const bool belongs_in_facet = keyword != StlKeyword::facet && keyword != StlKeyword::solid;
    if (keyword == StlKeyword::comment) continue;
    if (keyword == StlKeyword::none || belongs_in_facet != in_facet)
      reader.fail(in_facet ? "'vertex' with 3 numbers, or the end of the facet, is expected here"
                           : "'facet' is expected here");
    if (keyword == StlKeyword::facet) {
      facets.emplace_back();
      corners = 0;
      in_facet = true;
    } else if (keyword == StlKeyword::vertex) {
      if (words.size() < 4) reader.fail("'vertex' with 3 numbers is expected here");
      if (corners == 3) reader.fail("a facet has more than 3 vertices");
      for (std::size_t k = 0; k < 3; ++k)
        facets.back().corner[corners][static_cast<int>(k)] = static_cast<float>(reader.number(words[1 + k]));
      ++corners;
    } else if (keyword == StlKeyword::end_of_facet) {
      if (corners != 3) reader.fail("a facet has fewer than 3 vertices");
      in_facet = false;
    }
  }
  if (in_facet) reader.fail("the file ends within a facet");
  return facets;
}

std::vector<Facet> read_binary(const std::string& bytes, std::size_t count) {
  std::vector<Facet> facets(count);
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

/// Two programs put colours into the attributes. Materialise Magics has "COLOR=" with four bytes in the header, red in
/// the lowest bits, and the highest bit set where a facet has the colour of the header. VisCAM has blue in the lowest
/// bits, and the highest bit set where a facet has a colour.
void read_colors(const std::string& bytes, const std::vector<Facet>& facets, MeshFile& file) {
  constexpr std::string_view keyword = "COLOR=";
  const std::string_view header = std::string_view(bytes).substr(0, 80);
  const std::size_t at = header.find(keyword);
  const bool is_magics = at != header.npos && at + keyword.size() + 4 <= header.size();
  const auto has_bits = [](const Facet& facet) { return facet.attribute != 0; };
  // Some programs write the header, and no colours.
  const bool all_as_header = is_magics && std::none_of(facets.begin(), facets.end(), has_bits);
  vcg::Color4b of_header(255, 255, 255, 255);
  for (int k = 0; k < 4 && is_magics; ++k)
    of_header[k] = static_cast<unsigned char>(header[at + keyword.size() + static_cast<std::size_t>(k)]);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const std::uint16_t attribute = facets[i].attribute;
    const bool marked = attribute & color_bit;
    vcg::Color4b& color = file.mesh.face[i].C();
    if (is_magics)
      color = marked || all_as_header ? of_header : vcg::Color4b::FromUnsignedR5G5B5(attribute);
    else if (marked)
      color = vcg::Color4b::FromUnsignedB5G5R5(attribute);
    if (is_magics || marked) file.attributes |= face_color;
  }
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

StlKeyword stl_keyword(std::string_view word) {
  struct Entry {
    std::string_view word;
    StlKeyword keyword;
  };
  static constexpr Entry table[] = {
      {"vertex", StlKeyword::vertex}, {"facet", StlKeyword::facet},           {"outer", StlKeyword::loop},
      {"endloop", StlKeyword::loop},  {"endfacet", StlKeyword::end_of_facet}, {"solid", StlKeyword::solid},
      {"endsolid", StlKeyword::solid}};
  if (word[0] == ';') return StlKeyword::comment;
  for (const Entry& entry : table)
    if (std::equal(word.begin(), word.end(), entry.word.begin(), entry.word.end(),
                   [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; }))
      return entry.keyword;
  return StlKeyword::none;
}

StlLayout stl_layout(const std::string& bytes) {
  StlLayout layout;
  LineReader reader(std::string_view(bytes).substr(0, 4096), {});  // more than any program leaves blank
  std::vector<std::string_view> words;
  const bool is_solid = reader.next(words) && stl_keyword(words[0]) == StlKeyword::solid;
  layout.may_be_text = is_solid && bytes.find('\0') == bytes.npos;
  if (bytes.size() < header_size) return layout;
  std::uint32_t count = 0;
  char raw[sizeof count];
  std::memcpy(raw, bytes.data() + header_size - sizeof count, sizeof count);
  if (is_big_endian_machine()) std::reverse(raw, raw + sizeof count);
  std::memcpy(&count, raw, sizeof count);
  const std::size_t room = bytes.size() - header_size, fit = room / facet_size;
  layout.declared = count;
  layout.facets = count;
  layout.is_binary = room == count * facet_size;
  if (layout.is_binary || layout.may_be_text || count > fit) return layout;
  if (room % facet_size == 0) layout.facets = fit;  // all that follows are facets: the count is wrong
  layout.is_binary = layout.facets > 0;
  return layout;
}

MeshFile read_stl(const std::string& bytes, const std::filesystem::path& path) {
  const StlLayout layout = stl_layout(bytes);
  if (!layout.is_binary && !layout.may_be_text)
    fail(path, "is neither text STL, which begins with 'solid', nor binary STL, whose size is 84 + 50 bytes a facet");
  const std::vector<Facet> facets = layout.is_binary ? read_binary(bytes, layout.facets) : read_text(bytes, path);
  if (facets.empty()) fail(path, "holds no facets");
  MeshFile file;
  file.precision = Precision::single_precision;
  build(facets, file.mesh);
  if (layout.is_binary) {
    read_colors(bytes, facets, file);
    const std::size_t behind = bytes.size() - header_size - facets.size() * facet_size;
    if (layout.facets != layout.declared)
      file.warnings.push_back(path.string() + ": its header counts " + std::to_string(layout.declared) +
                              " facets, and there are " + std::to_string(layout.facets) + "; all are read");
    else if (behind > 0)
      file.warnings.push_back(path.string() + ": " + std::to_string(behind) +
                              " bytes behind the last facet are passed over");
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
    append(static_cast<std::uint16_t>(colored ? color_bit | vcg::Color4b::ToUnsignedB5G5R5(color) : 0));
  }
  return bytes;
}

}  // namespace mesh_tools::io
