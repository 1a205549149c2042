// SPDX-License-Identifier: GPL-3.0-or-later
// Geomview's OFF, with the prefixes N (normals) and C (colours).

#include <algorithm>

#include "colors.h"
#include "formats.h"
#include "off_header.h"
#include "polygons.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

using Words = std::vector<std::string_view>;

bool is_color(std::size_t words) { return words == 3 || words == 4; }

class OffReader {
 public:
  OffReader(const std::string& text, const std::filesystem::path& path, bool free)
      : path_(path), reader_(text, path), header_(read_off_header(reader_)), rows_(reader_, header_, free) {
    // A vertex takes at least six bytes ("0 0 0" and a line's end) and a face two, so that wrong counts cannot ask for
    // more memory than the file's size explains.
    const std::int64_t size = static_cast<std::int64_t>(text.size()) + 1;  // the last line's end may be missing
    if (header_.vertices > size / 6 || header_.faces > size / 2)
      reader_.fail("the counts of vertices and faces exceed the file");
    file_.free_layout = free;
  }

  FlatFile read() {
    read_vertices();
    for (std::int64_t f = 0; f < header_.faces; ++f) read_face();
    file_.color_scale = color_scale(vertex_colors_.largest());
    vertex_colors_.apply(file_.mesh.vertices(), file_.color_scale, file_.mesh.vertex_color);
    face_colors_.apply(file_.mesh.face.size(), color_scale(face_colors_.largest()), file_.mesh.face_color);
    note_small_faces(too_small_, path_, file_);
    return std::move(file_);
  }

 private:
  void read_vertices() {
    const auto count = static_cast<std::size_t>(header_.vertices);
    FlatMesh& mesh = file_.mesh;
    mesh.position.resize(count);
    if (header_.normals) {
      file_.attributes |= vertex_normal;
      mesh.vertex_normal.resize(count);
    }
    if (header_.texture) {
      file_.attributes |= vertex_texture;
      mesh.vertex_texture.resize(count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      rows_.next_vertex(words_);
      for (std::size_t k = 0; k < 3; ++k) {
        mesh.position.set(i, static_cast<int>(k), reader_.number(words_[k]));
        if (header_.normals) mesh.vertex_normal.set(i, static_cast<int>(k), reader_.number(words_[3 + k]));
      }
      if (header_.texture) {
        mesh.vertex_texture[i] = {static_cast<float>(reader_.number(words_[words_.size() - 2])),
                                  static_cast<float>(reader_.number(words_[words_.size() - 1]))};
        words_.resize(words_.size() - 2);
      }
      if (!header_.colors || !is_color(words_.size() - rows_.before_color())) continue;
      add_color(vertex_colors_, i, rows_.before_color());
      file_.attributes |= vertex_color;
    }
  }

  void read_face() {
    rows_.next_face(words_);
    const std::int64_t corners = reader_.integer(words_[0]);
    const std::size_t end = static_cast<std::size_t>(std::max<std::int64_t>(corners, 0)) + 1,
                      behind = words_.size() - end;
    // What is no face at all is no small one either.
    if (corners < 1 || (corners < 3 && behind > 1 && !is_color(behind)))
      reader_.fail("a face has " + std::to_string(corners) + " corners; at least 3 are needed");
    index_.clear();
    for (std::size_t k = 1; k < end; ++k) {
      const std::int64_t index = reader_.integer(words_[k]);
      if (index < 0 || index >= header_.vertices)
        reader_.fail("a face refers to vertex " + printable(words_[k]) + "; allowed are 0 to " +
                     std::to_string(header_.vertices - 1));
      index_.push_back(static_cast<std::uint32_t>(index));
    }
    if (corners < 3) {
      ++too_small_;
      return;
    }
    const bool colored = is_color(behind);
    if (colored) file_.attributes |= face_color;
    for (std::size_t k = 2; k < index_.size(); ++k) {
      file_.mesh.face.push_back({index_[0], index_[k - 1], index_[k]});
      if (colored) add_color(face_colors_, file_.mesh.face.size() - 1, end);
    }
    note_fan(index_.size(), file_);
  }

  /// 3 or 4 components, from the word `first` on.
  void add_color(RawColors& colors, std::size_t item, std::size_t first) const {
    for (std::size_t i = first; i < words_.size(); ++i) {
      const double value = reader_.number(words_[i]);
      if (!(value >= 0 && value <= 255)) reader_.fail("'" + printable(words_[i]) + "' is not a colour component");
      colors.add(item, static_cast<int>(i - first), value);
    }
  }

  std::filesystem::path path_;
  LineReader reader_;
  OffHeader header_;
  OffRows rows_;
  FlatFile file_;
  Words words_;
  std::vector<std::uint32_t> index_;
  RawColors vertex_colors_, face_colors_;
  std::size_t too_small_ = 0;
};

}  // namespace

FlatFile read_off(const std::string& text, const std::filesystem::path& path) {
  try {
    return OffReader(text, path, false).read();
  } catch (const FileError& as_lines) {
    // White space is free in OFF, but nearly all files have a vertex or a face a line, and more may stand behind a
    // vertex there than the header says.
    try {
      return OffReader(text, path, true).read();
    } catch (const FileError&) {
      throw as_lines;
    }
  }
}

namespace {

/// Scalar is what positions and normals are rounded to.
template <class Scalar>
std::string off_text(const FlatFile& file) {
  const FlatMesh& mesh = file.mesh;
  const int attributes = file.attributes;
  const bool normals = attributes & vertex_normal, colors = attributes & vertex_color;
  const bool face_colors = attributes & face_color;
  std::string text = std::string(colors ? "C" : "") + (normals ? "N" : "") + "OFF\n" + std::to_string(mesh.vertices()) +
                     " " + std::to_string(count_polygons(file).count) + " 0\n";
  const auto append_color = [&](const vcg::Color4b& color) {
    for (int k = 0; k < 4; ++k) append_whole(text += ' ', color[k]);
  };
  const auto append_point = [&](const vcg::Point3d& p) {
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text += ' ';
      append_number(text, static_cast<double>(static_cast<Scalar>(p[k])));
    }
  };
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    append_point(mesh.position[v]);
    if (normals) append_point((text += ' ', mesh.vertex_normal[v]));
    if (colors) append_color(mesh.vertex_color[v]);
    text += '\n';
  }
  visit_polygons(file, [&](std::size_t face, const std::uint32_t* first, const std::uint32_t* last) {
    append_whole(text, static_cast<std::uint64_t>(last - first));
    for (; first != last; ++first) append_whole(text += ' ', mesh.face[*first / 3][*first % 3]);
    if (face_colors) append_color(mesh.face_color[face]);
    text += '\n';
  });
  return text;
}

}  // namespace

std::string off_bytes(const FlatFile& file) {
  return file.precision == Precision::double_precision ? off_text<double>(file) : off_text<float>(file);
}

}  // namespace mesh_tools::io
