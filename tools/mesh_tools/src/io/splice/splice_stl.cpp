// SPDX-License-Identifier: GPL-3.0-or-later
#include "splice.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "../formats.h"
#include "../text.h"
#include "text_splicer.h"

namespace mesh_tools::io {
namespace {

using vcg::Point3d;
using Numbers = std::array<float, 12>;  // of a facet: its normal, its corners

constexpr std::size_t floats = std::tuple_size_v<Numbers>;

/// What a facet becomes. Numbers that are the same stay as they are: 0 and -0 have other bytes. The normal stays where
/// no corner moves, and where the facet has no direction.
Numbers moved_facet(const Numbers& before, const FlatMesh& mesh, std::size_t face) {
  Numbers now = before;
  bool moved = false;
  const auto replace = [&](std::size_t i, double by) {
    const auto number = static_cast<float>(by);
    const bool same = is_same_number(before[i], number);
    now[i] = same ? before[i] : number;
    moved |= !same;
  };
  Point3d corner[3];
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = mesh.position[mesh.face[face][k]];
    for (std::size_t i = 0; i < 3; ++i) replace(3 + 3 * k + i, corner[k][static_cast<int>(i)]);
  }
  if (!moved) return now;
  const Point3d normal = (corner[1] - corner[0]) ^ (corner[2] - corner[0]);
  const double length = normal.Norm();
  if (length > 0 && std::isfinite(length))
    for (std::size_t i = 0; i < 3; ++i) replace(i, normal[static_cast<int>(i)] / length);
  return now;
}

void reverse_on_big_endian(char (&raw)[floats * sizeof(float)]) {
  if (!is_big_endian_machine()) return;
  for (std::size_t i = 0; i < floats; ++i) std::reverse(raw + i * sizeof(float), raw + (i + 1) * sizeof(float));
}

void splice_facet(char* facet, const FlatMesh& mesh, std::size_t face) {
  char raw[floats * sizeof(float)];
  std::memcpy(raw, facet, sizeof raw);
  reverse_on_big_endian(raw);
  Numbers before;
  std::memcpy(before.data(), raw, sizeof raw);
  const Numbers now = moved_facet(before, mesh, face);
  std::memcpy(raw, now.data(), sizeof raw);
  reverse_on_big_endian(raw);
  std::memcpy(facet, raw, sizeof raw);
}

void splice_binary(ByteSource& bytes, std::size_t facets, const SpliceInput& input, const Write& write) {
  constexpr std::size_t facets_at_a_time = 4096;
  const FlatMesh& mesh = input.file.mesh;
  check_same_count(input.path, "facets", mesh.face.size(), facets);
  write({bytes.part(0, stl_header_size), stl_header_size});
  std::string spliced;
  for (std::size_t begin = 0; begin < facets; begin += facets_at_a_time) {
    const std::size_t count = std::min(facets_at_a_time, facets - begin);
    spliced.assign(bytes.part(stl_facet_offset(begin), count * stl_facet_size), count * stl_facet_size);
    for (std::size_t i = 0; i < count; ++i) splice_facet(spliced.data() + i * stl_facet_size, mesh, begin + i);
    write(spliced);
  }
  const std::size_t behind = bytes.size() - stl_facet_offset(facets);
  if (behind > 0) write({bytes.part(stl_facet_offset(facets), behind), behind});
}

/// The reader does not look at normals, so they may be anything; what is no number is NaN.
float normal_number(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? static_cast<float>(value) : std::nanf("");
}

void splice_text(const std::string& bytes, const SpliceInput& input, const Write& write) {
  const FlatMesh& mesh = input.file.mesh;
  TextSplicer text(bytes, write);
  LineReader reader(bytes, input.path);
  std::vector<std::string_view> words;
  std::array<std::string_view, floats> facet;
  Numbers before{};
  std::size_t found = 0, next = 0, first = 0;
  while (reader.next(words)) {
    const StlKeyword keyword = stl_keyword(words[0]);
    if (keyword == StlKeyword::facet) {
      // A facet may have no normal, or something else in its place.
      first = words.size() < 5 ? 3 : 0;
      next = 3;
      for (std::size_t k = 0; k < 3 && first == 0; ++k) {
        facet[k] = words[2 + k];
        before[k] = normal_number(facet[k]);
      }
    }
    if (keyword != StlKeyword::vertex) continue;
    if (words.size() < 4 || next + 3 > floats) reader.fail("is no vertex of 3 numbers, or one too many");
    for (std::size_t k = 0; k < 3; ++k, ++next) {
      facet[next] = words[1 + k];
      before[next] = static_cast<float>(reader.number(facet[next]));
    }
    if (next < floats) continue;
    if (found < mesh.face.size()) {
      const Numbers now = moved_facet(before, mesh, found);
      for (std::size_t i = first; i < floats; ++i) text.replace_number(facet[i], before[i], now[i]);
    }
    ++found;
  }
  check_same_count(input.path, "facets", mesh.face.size(), found);
  text.finish();
}

}  // namespace

void splice_stl(ByteSource& bytes, const SpliceInput& input, const Write& write) {
  const StlLayout layout = stl_layout(bytes);
  if (layout.is_binary)
    splice_binary(bytes, layout.facets, input, write);
  else
    splice_text(bytes.whole(), input, write);
}

}  // namespace mesh_tools::io
