// SPDX-License-Identifier: GPL-3.0-or-later
#include "off_header.h"

#include <string>

#include "formats.h"

namespace mesh_tools::io {

OffHeader read_off_header(LineReader& reader) {
  std::vector<std::string_view> words;
  if (!reader.next(words)) reader.fail("holds no OFF header");
  std::string_view keyword = words[0], glued;
  if (const std::size_t digit = keyword.find_first_of("0123456789"); digit != keyword.npos && digit >= 3) {
    glued = keyword.substr(digit);
    keyword = keyword.substr(0, digit);
  }
  if (keyword.size() < 3 || keyword.substr(keyword.size() - 3) != "OFF")
    reader.fail("the file must begin with the word OFF, CNOFF, COFF or NOFF");
  OffHeader header;
  for (std::string_view prefix = keyword.substr(0, keyword.size() - 3); !prefix.empty();) {
    if (prefix.substr(0, 2) == "ST") {
      header.texture = true;
      prefix.remove_prefix(2);
      continue;
    }
    if (prefix[0] == 'C')
      header.colors = true;
    else if (prefix[0] == 'N')
      header.normals = true;
    else
      reader.fail("header '" + printable(keyword) + "' is not supported; allowed prefixes are ST, C and N");
    prefix.remove_prefix(1);
  }
  if (glued.empty())
    words.erase(words.begin());
  else
    words[0] = glued;
  if (words.size() == 1 && words[0] == "BINARY") reader.fail("binary OFF is not supported; text is");
  if (words.empty() && !reader.next(words)) reader.fail("the counts of vertices and faces are missing");
  if (words.size() < 2) reader.fail("the counts of vertices and faces are missing");
  header.vertices = reader.integer(words[0]);
  header.faces = reader.integer(words[1]);
  if (header.vertices < 0 || header.faces < 0) reader.fail("a count is negative");
  return header;
}

void OffRows::fail_at_end() const {
  reader_.fail("the file ends before its " + std::to_string(in_faces_ ? header_.faces : header_.vertices) +
               (in_faces_ ? " faces" : " vertices"));
}

std::string_view OffRows::take() {
  if (used_ == line_.size()) {
    used_ = 0;
    if (!reader_.next(line_)) fail_at_end();
  }
  return line_[used_++];
}

void OffRows::next_vertex(Words& words) {
  if (!free_) {
    if (!reader_.next(words)) fail_at_end();
    if (words.size() < before_color() + behind_color()) reader_.fail("a vertex has too few numbers");
    return;
  }
  words.clear();
  const std::size_t color = header_.colors ? 4 : 0;
  for (std::size_t left = before_color() + color + behind_color(); left > 0; --left) words.push_back(take());
}

void OffRows::next_face(Words& words) {
  in_faces_ = true;
  if (free_) {
    words.assign(1, take());
    for (std::int64_t left = reader_.integer(words[0]); left > 0; --left) words.push_back(take());
    while (used_ < line_.size()) words.push_back(take());
    return;
  }
  if (!reader_.next(words)) fail_at_end();
  const std::int64_t corners = reader_.integer(words[0]);
  if (corners >= 0 && words.size() - 1 < static_cast<std::uint64_t>(corners))
    reader_.fail("a face has fewer vertices than it says");
}

}  // namespace mesh_tools::io
