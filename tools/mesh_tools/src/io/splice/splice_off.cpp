#include "splice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

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
  OffSplicer(const std::string& bytes, const SpliceInput& input)
      : bytes_(bytes), input_(input), mesh_(input.file.mesh), text_(bytes) {}

  std::string splice() {
    LineReader header_reader(bytes_, input_.path);
    header_ = read_off_header(header_reader);
    check_same_count(input_.path, "vertices", mesh_.vert.size(), static_cast<std::size_t>(header_.vertices));
    if (header_.normals) renew_normals(header_reader);
    LineReader reader(bytes_, input_.path);
    read_off_header(reader);
    for (std::size_t i = 0; i < mesh_.vert.size(); ++i) {
      next_vertex(reader, i);
      put_point(0, point(reader, words_, 0), mesh_.vert[i].cP());
      if (normals_)
        if (const auto normal = normals_->normal(i)) put_point(3, old_normals_[i], *normal);
      if (input_.recolored && header_.colors) put_color(reader, mesh_.vert[i].cC());
    }
    return text_.finish();
  }

 private:
  void next_vertex(LineReader& reader, std::size_t index) {
    if (!reader.next(words_)) check_same_count(input_.path, "vertices", mesh_.vert.size(), index);
    if (words_.size() < first_color()) reader.fail("a vertex has too few numbers");
  }

  std::size_t first_color() const { return header_.normals ? 6 : 3; }

  void renew_normals(LineReader& reader) {
    for (std::size_t i = 0; i < mesh_.vert.size(); ++i) {
      next_vertex(reader, i);
      vertices_.add(point(reader, words_, 0), mesh_.vert[i].cP());
      old_normals_.push_back(point(reader, words_, 3));
    }
    normals_.emplace(mesh_, vertices_, old_normals_);
    normals_->add_triangles();
    normals_->finish();
  }

  void put_point(std::size_t first, const Point3d& before, const Point3d& now) {
    for (int k = 0; k < 3; ++k) text_.replace_number(words_[first + static_cast<std::size_t>(k)], before[k], now[k]);
  }

  /// In the form that the line has: fractions with a point, or whole numbers up to 255.
  void put_color(const LineReader& reader, const vcg::Color4b& now) {
    const std::size_t first = first_color(), texture = header_.texture ? 2 : 0;
    if (words_.size() < first + texture + 3 || words_.size() > first + texture + 4) return;
    const std::size_t last = words_.size() - texture;
    bool fractions = false;
    for (std::size_t i = first; i < last; ++i) fractions |= words_[i].find('.') != std::string_view::npos;
    for (std::size_t i = first; i < last; ++i) {
      const unsigned char byte = now[static_cast<int>(i - first)];
      if (std::lround(reader.number(words_[i]) * (fractions ? 255 : 1)) == byte) continue;
      std::string number;
      append_number(number, fractions ? byte / 255.0 : byte);
      if (fractions && number.find('.') == std::string::npos) number += ".0";
      text_.replace(words_[i], number);
    }
  }

  const std::string& bytes_;
  const SpliceInput& input_;
  const Mesh& mesh_;
  TextSplicer text_;
  OffHeader header_;
  Words words_;
  MovedVertices vertices_;
  std::vector<Point3d> old_normals_;
  std::optional<MovedNormals> normals_;
};

}  // namespace

std::string splice_off(std::string bytes, const SpliceInput& input) { return OffSplicer(bytes, input).splice(); }

}  // namespace mesh_tools::io
