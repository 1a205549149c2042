// SPDX-License-Identifier: GPL-3.0-or-later
#include "splice.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "../colors.h"
#include "../file_names.h"
#include "../formats.h"
#include "../text.h"
#include "moved_normals.h"
#include "text_splicer.h"

namespace mesh_tools::io {
namespace {

using Words = std::vector<std::string_view>;
using vcg::Point3d;

/// Index from 1, or from -1 backwards, to an index from 0; -1 if it is none, or far out of range.
std::int64_t index_of(std::string_view word, std::size_t count) {
  std::int64_t given = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), given);
  if (error != std::errc() || end != word.data() + word.size()) return -1;
  return given < 0 ? static_cast<std::int64_t>(count) + given : given - 1;
}

class ObjSplicer {
 public:
  ObjSplicer(const std::string& bytes, const SpliceInput& input, const std::filesystem::path& out, const Write& write)
      : bytes_(bytes), input_(input), mesh_(input.file.mesh), out_(out), text_(bytes, write) {}

  /// Normals follow from all vertices and faces, so these are read before.
  void splice() {
    if (bytes_.find("vn") != bytes_.npos) read();
    if (!old_normals_.empty()) renew_normals();
    LineReader reader(bytes_, input_.path, Comments::outside_names);
    std::size_t vertex = 0, normal = 0;
    while (reader.next(words_)) {
      if (words_[0] == "v")
        put_vertex(reader, vertex++);
      else if (words_[0] == "vn")
        put_normal(normal++);
      else if (words_[0] == "mtllib" && words_.size() > 1)
        put_material_names();
    }
    check_same_count(input_.path, "vertices", mesh_.vertices(), vertex);
    text_.finish();
  }

 private:
  Point3d point(const LineReader& reader) const {
    if (words_.size() < 4) reader.fail("has fewer than 3 numbers");
    return {reader.number(words_[1]), reader.number(words_[2]), reader.number(words_[3])};
  }

  /// Finds what vertices and normals were, and how faces refer to them.
  void read() {
    LineReader reader(bytes_, input_.path, Comments::outside_names);
    while (reader.next(words_)) {
      if (words_[0] == "v")
        add_vertex(point(reader));
      else if (words_[0] == "vn")
        old_normals_.push_back(point(reader));
      else if (words_[0] == "f")
        read_face();
    }
    check_same_count(input_.path, "vertices", mesh_.vertices(), vertices_.before.size());
  }

  void add_vertex(const Point3d& before) {
    const std::size_t index = vertices_.before.size();
    vertices_.add(before, index < mesh_.vertices() ? mesh_.position[index] : before);  // too many: refused later
  }

  /// Indices may count back from here, so they are found out now; what they refer to may come later.
  void read_face() {
    for (std::size_t i = 1; i < words_.size(); ++i) {
      const std::string_view word = words_[i];
      const std::size_t first = word.find('/'), second = first == word.npos ? word.npos : word.find('/', first + 1);
      const std::int64_t vertex = index_of(word.substr(0, first), vertices_.before.size());
      const std::int64_t normal = second == word.npos ? -1 : index_of(word.substr(second + 1), old_normals_.size());
      corners_.push_back({as_index(vertex), as_index(normal)});
    }
    face_ends_.push_back(corners_.size());
  }

  static std::uint32_t as_index(std::int64_t index) {
    return index >= 0 && index < nothing ? static_cast<std::uint32_t>(index) : nothing;
  }

  void renew_normals() {
    normals_.emplace(mesh_, vertices_, old_normals_);
    std::vector<MovedNormals::Corner> face;
    std::size_t start = 0;
    for (const std::size_t end : face_ends_) {
      face.assign(corners_.begin() + static_cast<std::ptrdiff_t>(start),
                  corners_.begin() + static_cast<std::ptrdiff_t>(end));
      start = end;
      const bool is_whole = std::all_of(face.begin(), face.end(), [&](const MovedNormals::Corner& corner) {
        return corner.vertex < mesh_.vertices() && corner.normal < old_normals_.size();
      });
      if (is_whole && face.size() >= 3) normals_->add_face(face);
    }
    normals_->finish();
  }

  /// The k-th number of a statement, whose numbers begin with the word `first`.
  std::string_view number_word(std::size_t first, int k) const { return words_[first + static_cast<std::size_t>(k)]; }

  void put_vertex(const LineReader& reader, std::size_t index) {
    const Point3d before = point(reader);
    if (index >= mesh_.vertices()) return;  // refused later
    for (int k = 0; k < 3; ++k) text_.replace_number(number_word(1, k), before[k], mesh_.position.number(index, k));
    if (input_.recolored && words_.size() >= 7 && !mesh_.vertex_color.empty())
      put_color(reader, mesh_.vertex_color[index]);
  }

  void put_color(const LineReader& reader, const vcg::Color4b& now) {
    const double scale = input_.file.color_scale;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = number_word(4, k);
      if (color_byte(scale * reader.number(word)) != now[k]) text_.replace_number(word, std::nan(""), now[k] / scale);
    }
  }

  void put_normal(std::size_t index) {
    const std::optional<Point3d> normal = normals_->normal(index);
    if (!normal) return;
    for (int k = 0; k < 3; ++k) text_.replace_number(number_word(1, k), old_normals_[index][k], (*normal)[k]);
  }

  /// All that is behind the word: a name may hold spaces.
  void put_material_names() {
    const std::string_view names = span(words_, 1);
    if (names.find_first_of("\r\n") != names.npos) return;  // a continued line
    text_.replace(names, moved_material_names(names, input_.path.parent_path(), out_.parent_path()));
  }

  static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

  const std::string& bytes_;
  const SpliceInput& input_;
  const FlatMesh& mesh_;
  const std::filesystem::path& out_;
  TextSplicer text_;
  Words words_;
  MovedVertices vertices_;
  std::vector<Point3d> old_normals_;
  std::vector<MovedNormals::Corner> corners_;  // of all faces, one behind the other
  std::vector<std::size_t> face_ends_;
  std::optional<MovedNormals> normals_;
};

}  // namespace

void splice_obj(const std::string& bytes, const SpliceInput& input, const std::filesystem::path& out,
                const Write& write) {
  ObjSplicer(bytes, input, out, write).splice();
}

}  // namespace mesh_tools::io
