// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "text.h"

namespace mesh_tools::io {

/// What an OFF file declares: its prefixes and counts.
struct OffHeader {
  bool normals = false, colors = false, texture = false;
  std::int64_t vertices = 0, faces = 0;
};

/// Reads the lines up to the first vertex; throws FileError where they are no header. The count of vertices may be
/// glued to the word OFF, as in ModelNet40.
OffHeader read_off_header(LineReader& reader);

/// The words of vertices and faces, behind the header.
class OffRows {
 public:
  using Words = std::vector<std::string_view>;

  /// Both are referred to.
  /// @param free  whether vertices and faces are not one a line: they end where they have as many words as they need;
  ///              behind a face, its line may hold a colour
  OffRows(LineReader& reader, const OffHeader& header, bool free) : reader_(reader), header_(header), free_(free) {}

  /// How many words a vertex has before its colour, and behind it.
  std::size_t before_color() const { return header_.normals ? 6 : 3; }
  std::size_t behind_color() const { return header_.texture ? 2 : 0; }

  /// Throw FileError where there is no further one, or too little of it. The words of a face begin with the count of
  /// its corners.
  void next_vertex(Words& words);
  void next_face(Words& words);

 private:
  std::string_view take();
  [[noreturn]] void fail_at_end() const;

  LineReader& reader_;
  const OffHeader& header_;
  bool free_;
  Words line_;            // where free: the words of the last line,
  std::size_t used_ = 0;  // of which so many are handed out
  bool in_faces_ = false;
};

}  // namespace mesh_tools::io
