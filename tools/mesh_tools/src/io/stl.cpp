// SPDX-License-Identifier: GPL-3.0-or-later
// STL, text and binary. vcglib's reader is not used: it runs past its buffer on any header without a zero byte, and
// trusts the number of facets.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "byte_source.h"
#include "formats.h"
#include "large_pages.h"
#include "text.h"
#include "vertex_merger.h"

namespace mesh_tools::io {
namespace {

constexpr std::uint16_t color_bit = 0x8000;  // of a facet's attribute

/// The corners of a text file's facets, three of each.
class TextFacets {
 public:
  explicit TextFacets(std::vector<vcg::Point3f> corner) : corner_(std::move(corner)) {}

  std::size_t size() const { return corner_.size() / 3; }
  void read_corners(std::size_t begin, std::size_t count, vcg::Point3f* corner) const {
    std::copy_n(corner_.begin() + static_cast<std::ptrdiff_t>(3 * begin), 3 * count, corner);
  }

 private:
  std::vector<vcg::Point3f> corner_;
};

/// Programs write keywords in small letters or capitals, put words behind them, leave normals out. So what counts are
/// the vertices, and that there are three between the facet's beginning and end.
TextFacets read_text(const std::string& bytes, const std::filesystem::path& path) {
  LineReader reader(bytes, path);
  std::vector<std::string_view> words;
  std::vector<vcg::Point3f> corner;
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
      corners = 0;
      in_facet = true;
    } else if (keyword == StlKeyword::vertex) {
      if (words.size() < 4) reader.fail("'vertex' with 3 numbers is expected here");
      if (corners == 3) reader.fail("a facet has more than 3 vertices");
      corner.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        corner.back()[static_cast<int>(k)] = static_cast<float>(reader.number(words[1 + k]));
      ++corners;
    } else if (keyword == StlKeyword::end_of_facet) {
      if (corners != 3) reader.fail("a facet has fewer than 3 vertices");
      in_facet = false;
    }
  }
  if (in_facet) reader.fail("the file ends within a facet");
  return TextFacets(std::move(corner));
}

/// The facets of a binary file, where they are.
class BinaryFacets {
 public:
  BinaryFacets(ByteSource& bytes, std::size_t count) : bytes_(bytes), count_(count) {}

  std::size_t size() const { return count_; }

  /// Not the normals, which follow from the corners.
  void read_corners(std::size_t begin, std::size_t count, vcg::Point3f* corner) {
    const char* facet = bytes_.part(stl_facet_offset(begin), count * stl_facet_size);
    for (std::size_t i = 0; i < count; ++i, facet += stl_facet_size, corner += 3) {
      const char* at = facet + 3 * sizeof(float);
      for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 3; ++k, at += sizeof(float)) corner[c][k] = number_at<float>(at);
      attributes_ |= number_at<std::uint16_t>(at);
    }
  }

  std::uint16_t attribute(std::size_t i) {
    return number_at<std::uint16_t>(bytes_.part(stl_facet_offset(i), stl_facet_size) + 12 * sizeof(float));
  }
  /// The bits of all facets whose corners have been read.
  std::uint16_t attributes() const { return attributes_; }

 private:
  ByteSource& bytes_;
  std::size_t count_;
  std::uint16_t attributes_ = 0;
};

/// Two programs put colours into the attributes. Materialise Magics has "COLOR=" with four bytes in the header, red in
/// the lowest bits, and the highest bit set where a facet has the colour of the header. VisCAM has blue in the lowest
/// bits, and the highest bit set where a facet has a colour.
void read_colors(ByteSource& bytes, BinaryFacets& facets, FlatFile& file) {
  constexpr std::string_view keyword = "COLOR=";
  const std::string header(bytes.part(0, 80), 80);
  const std::size_t at = header.find(keyword);
  const bool is_magics = at != header.npos && at + keyword.size() + 4 <= header.size();
  const bool has_bits = facets.attributes() != 0, has_marks = (facets.attributes() & color_bit) != 0;
  if (!is_magics && !has_marks) return;
  const bool all_as_header = is_magics && !has_bits;  // some programs write the header, and no colours
  vcg::Color4b of_header(255, 255, 255, 255);
  for (int k = 0; k < 4 && is_magics; ++k)
    of_header[k] = static_cast<unsigned char>(header[at + keyword.size() + static_cast<std::size_t>(k)]);
  file.attributes |= face_color;
  file.mesh.face_color.assign(facets.size(), vcg::Color4b(255, 255, 255, 255));
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const std::uint16_t attribute = facets.attribute(i);
    const bool marked = (attribute & color_bit) != 0;
    vcg::Color4b& color = file.mesh.face_color[i];
    if (is_magics)
      color = marked || all_as_header ? of_header : vcg::Color4b::FromUnsignedR5G5B5(attribute);
    else if (marked)
      color = vcg::Color4b::FromUnsignedB5G5R5(attribute);
  }
}

template <class Facets>
void build(Facets& facets, const std::filesystem::path& path, FlatMesh& mesh) {
  if (facets.size() == 0) fail(path, "holds no facets");
  constexpr std::size_t most_facets = std::numeric_limits<std::uint32_t>::max() / 3;
  if (facets.size() > most_facets)
    fail(path,
         "has " + std::to_string(facets.size()) + " facets; at most " + std::to_string(most_facets) + " can be read");
  VertexMerger merger(3 * facets.size(), mesh.position);
  reserve_in_large_pages(mesh.face, facets.size());
  constexpr std::size_t largest_block = VertexMerger::largest_block / 3;
  vcg::Point3f corner[3 * largest_block];
  std::uint32_t vertex[3 * largest_block];
  for (std::size_t begin = 0; begin < facets.size(); begin += largest_block) {
    const std::size_t block = std::min(largest_block, facets.size() - begin);
    facets.read_corners(begin, block, corner);
    merger.merge(corner, 3 * block, vertex);
    for (std::size_t i = 0; i < block; ++i) mesh.face.push_back({vertex[3 * i], vertex[3 * i + 1], vertex[3 * i + 2]});
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

StlLayout stl_layout(ByteSource& bytes) {
  StlLayout layout;
  const std::size_t looked_at = std::min<std::size_t>(bytes.size(), 4096);  // more than any program leaves blank
  const std::string beginning(bytes.part(0, looked_at), looked_at);
  LineReader reader(beginning, {});
  std::vector<std::string_view> words;
  const bool is_solid = reader.next(words) && stl_keyword(words[0]) == StlKeyword::solid;
  layout.may_be_text = is_solid && bytes.whole().find('\0') == std::string::npos;
  if (bytes.size() < stl_header_size) return layout;
  const auto count = number_at<std::uint32_t>(beginning.data() + stl_header_size - sizeof(std::uint32_t));
  const std::size_t room = bytes.size() - stl_header_size, fit = room / stl_facet_size;
  layout.declared = count;
  layout.facets = count;
  layout.is_binary = room == count * stl_facet_size;
  if (layout.is_binary || layout.may_be_text || count > fit) return layout;
  if (room % stl_facet_size == 0) layout.facets = fit;  // all that follows are facets: the count is wrong
  layout.is_binary = layout.facets > 0;
  return layout;
}

FlatFile read_stl(ByteSource& bytes, const std::filesystem::path& path) {
  const StlLayout layout = stl_layout(bytes);
  if (!layout.is_binary && !layout.may_be_text)
    fail(path, "is neither text STL, which begins with 'solid', nor binary STL, whose size is 84 + 50 bytes a facet");
  FlatFile file;
  file.precision = Precision::single_precision;
  file.mesh.position = Points(file.precision);
  if (!layout.is_binary) {
    TextFacets facets = read_text(bytes.whole(), path);
    build(facets, path, file.mesh);
    return file;
  }
  BinaryFacets facets(bytes, layout.facets);
  build(facets, path, file.mesh);
  read_colors(bytes, facets, file);
  const std::size_t behind = bytes.size() - stl_facet_offset(facets.size());
  if (layout.facets != layout.declared)
    file.warnings.push_back(path.string() + ": its header counts " + std::to_string(layout.declared) +
                            " facets, and there are " + std::to_string(layout.facets) + "; all are read");
  else if (behind > 0)
    file.warnings.push_back(path.string() + ": " + std::to_string(behind) +
                            " bytes behind the last facet are passed over");
  return file;
}

std::string stl_bytes(const FlatFile& file) {
  const FlatMesh& mesh = file.mesh;
  std::string bytes = "VCG";
  bytes.resize(stl_header_size - sizeof(std::uint32_t), ' ');
  bytes.reserve(stl_facet_offset(mesh.face.size()));
  const auto append_point = [&bytes](const vcg::Point3d& p) {
    for (int k = 0; k < 3; ++k) append_binary(bytes, static_cast<float>(p[k]));
  };
  append_binary(bytes, static_cast<std::uint32_t>(mesh.face.size()));
  const bool colored = (file.attributes & face_color) != 0 && !mesh.face_color.empty();
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    const auto& face = mesh.face[f];
    const vcg::Point3d corner[3] = {mesh.position[face[0]], mesh.position[face[1]], mesh.position[face[2]]};
    append_point(((corner[1] - corner[0]) ^ (corner[2] - corner[0])).Normalize());
    for (const vcg::Point3d& place : corner) append_point(place);
    vcg::Color4b color = colored ? mesh.face_color[f] : vcg::Color4b();
    append_binary(bytes, static_cast<std::uint16_t>(colored ? color_bit | vcg::Color4b::ToUnsignedB5G5R5(color) : 0));
  }
  return bytes;
}

}  // namespace mesh_tools::io
