// SPDX-License-Identifier: GPL-3.0-or-later
#include "splice.h"

#include <optional>
#include <string_view>
#include <vector>

#include "../colors.h"
#include "../formats.h"
#include "../off_header.h"
#include "../text.h"
#include "moved_normals.h"
#include "text_splicer.h"

namespace mesh_tools::io {
namespace {

using Words = std::vector<std::string_view>;
using vcg::Point3d;

Point3d point(const LineReader& reader, const Words& words, std::size_t first) {
  return {reader.number(words[first]), reader.number(words[first + 1]), reader.number(words[first + 2])};
}

class OffSplicer {
 public:
  OffSplicer(const std::string& bytes, const SpliceInput& input, const Write& write)
      : bytes_(bytes), input_(input), mesh_(input.file.mesh), text_(bytes, write) {}

  void splice() {
    LineReader first_reader(bytes_, input_.path), reader(bytes_, input_.path);
    header_ = read_off_header(first_reader);
    read_off_header(reader);
    check_same_count(input_.path, "vertices", mesh_.vertices(), static_cast<std::size_t>(header_.vertices));
    if (header_.normals) renew_normals(first_reader);
    OffRows rows(reader, header_, input_.file.free_layout);
    for (std::size_t i = 0; i < mesh_.vertices(); ++i) {
      rows.next_vertex(words_);
      put_point(0, point(reader, words_, 0), mesh_.position[i]);
      if (normals_)
        if (const auto normal = normals_->normal(i)) put_point(3, old_normals_[i], *normal);
      if (input_.recolored && header_.colors && !mesh_.vertex_color.empty())
        put_color(reader, rows, mesh_.vertex_color[i]);
    }
    text_.finish();
  }

 private:
  void renew_normals(LineReader& reader) {
    OffRows rows(reader, header_, input_.file.free_layout);
    for (std::size_t i = 0; i < mesh_.vertices(); ++i) {
      rows.next_vertex(words_);
      vertices_.add(point(reader, words_, 0), mesh_.position[i]);
      old_normals_.push_back(point(reader, words_, 3));
    }
    normals_.emplace(mesh_, vertices_, old_normals_);
    normals_->add_triangles();
    normals_->finish();
  }

  void put_point(std::size_t first, const Point3d& before, const Point3d& now) {
    for (int k = 0; k < 3; ++k) text_.replace_number(words_[first + static_cast<std::size_t>(k)], before[k], now[k]);
  }

  /// In the form that the file has: fractions with a point, or whole numbers up to 255.
  void put_color(const LineReader& reader, const OffRows& rows, const vcg::Color4b& now) {
    const std::size_t first = rows.before_color(), last = words_.size() - rows.behind_color();
    if (last < first + 3 || last > first + 4) return;
    const double scale = input_.file.color_scale;
    for (std::size_t i = first; i < last; ++i) {
      const unsigned char byte = now[static_cast<int>(i - first)];
      if (color_byte(scale * reader.number(words_[i])) == byte) continue;
      std::string number;
      append_number(number, byte / scale);
      if (scale != 1 && number.find('.') == std::string::npos) number += ".0";
      text_.replace(words_[i], number);
    }
  }

  const std::string& bytes_;
  const SpliceInput& input_;
  const FlatMesh& mesh_;
  TextSplicer text_;
  OffHeader header_;
  Words words_;
  MovedVertices vertices_;
  std::vector<Point3d> old_normals_;
  std::optional<MovedNormals> normals_;
};

}  // namespace

void splice_off(const std::string& bytes, const SpliceInput& input, const Write& write) {
  OffSplicer(bytes, input, write).splice();
}

}  // namespace mesh_tools::io
