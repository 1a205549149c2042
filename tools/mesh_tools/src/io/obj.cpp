// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Wavefront OBJ: v (with colour), vt, vn, f, l, and materials for face colour and texture.

#include <algorithm>
#include <set>
#include <utility>

#include "colors.h"
#include "formats.h"
#include "obj_materials.h"
#include "polygons.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

using Words = std::vector<std::string_view>;

class ObjReader {
 public:
  ObjReader(const std::string& text, const std::filesystem::path& path)
      : path_(path), reader_(text, path, Comments::outside_names), materials_(path.parent_path()) {}

  FlatFile read() {
    Words words;
    while (reader_.next(words)) {
      const std::string_view what = words[0];
      if (what == "v")
        read_vertex(words);
      else if (what == "vt")
        textures_.push_back(read_texture(words));
      else if (what == "vn")
        normals_.push_back(read_point(words, "a vertex normal"));
      else if (what == "f")
        read_face(words);
      else if (what == "l")
        read_line(words);
      else if (what == "mtllib")
        read_materials(words);
      else if (what == "usemtl")
        material_ = materials_.find(words);
      else if (unknown_.size() < most_unknown)
        unknown_.emplace(printable(what));
    }
    build();
    return std::move(file_);
  }

 private:
  struct Corner {
    std::int64_t vertex, texture, normal;  // -1: none; a normal may be any number
  };
  static constexpr std::int64_t no_normal = -1, bad_normal = -2;
  using Texture = FlatMesh::TextureCoordinate;
  struct Face {
    std::size_t first_corner;  // in corners_; they end where those of the next face begin
    int material;
  };
  /// A reference to what had not come yet when it was read.
  struct Forward {
    std::size_t line;
    std::int64_t index;
    bool to_texture;
  };
  vcg::Point3d read_point(const Words& words, const char* name) const {
    if (words.size() < 4) reader_.fail(std::string(name) + " has fewer than 3 numbers");
    return {reader_.number(words[1]), reader_.number(words[2]), reader_.number(words[3])};
  }

  void read_vertex(const Words& words) {
    positions_.push_back(read_point(words, "a vertex"));
    for (std::size_t k = 0; k < 3 && words.size() >= 7; ++k)
      colors_.add(positions_.size() - 1, static_cast<int>(k), reader_.number(words[4 + k]));
  }

  Texture read_texture(const Words& words) const {
    if (words.size() < 2) reader_.fail("a texture coordinate has no numbers");
    return {static_cast<float>(reader_.number(words[1])),
            words.size() < 3 ? 0.0f : static_cast<float>(reader_.number(words[2]))};
  }

  /// Index from 1, or from -1 backwards, to an index from 0. It may be of what comes later.
  std::int64_t index(std::string_view word, std::size_t count, const char* name, bool to_texture) {
    const std::int64_t given = reader_.integer(word), size = static_cast<std::int64_t>(count);
    const std::int64_t result = given < 0 ? size + given : given - 1;
    if (given == 0 || result < 0)
      reader_.fail("refers to " + std::string(name) + " " + printable(word) + "; before this line there are " +
                   std::to_string(count));
    if (result >= size) forward_.push_back({reader_.line(), result, to_texture});
    return result;
  }

  Corner read_corner(std::string_view word) {
    const std::size_t first = word.find('/'), second = first == word.npos ? word.npos : word.find('/', first + 1);
    Corner corner{index(word.substr(0, first), positions_.size(), "vertex", false), -1, -1};
    if (first == word.npos) return corner;
    const std::string_view texture = word.substr(first + 1, second == word.npos ? word.npos : second - first - 1);
    // Files from which all texture coordinates or normals were removed are common, and faces refer to them still.
    if (!texture.empty() && !(textures_.empty() && texture[0] == '-'))
      corner.texture = index(texture, textures_.size(), "texture coordinate", true);
    if (second != word.npos && second + 1 < word.size()) {
      const std::int64_t given = reader_.integer(word.substr(second + 1));
      // Normals are made anew anyway: a bad one is passed over.
      corner.normal = given < 0 ? static_cast<std::int64_t>(normals_.size()) + given : given - 1;
      if (corner.normal < 0) corner.normal = bad_normal;
    }
    return corner;
  }

  void read_face(const Words& words) {
    const std::size_t first = corners_.size();
    for (std::size_t i = 1; i < words.size(); ++i) corners_.push_back(read_corner(words[i]));
    if (words.size() < 4) {
      ++too_small_;
      corners_.resize(first);
      return;
    }
    triangles_ += words.size() - 3;
    faces_.push_back({first, material_});
  }

  void read_line(const Words& words) {
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::uint32_t first = vertex_of(read_corner(words[i - 1]));
      file_.mesh.edge.push_back({first, vertex_of(read_corner(words[i]))});
    }
  }

  void read_materials(const Words& words) {
    if (words.size() < 2) reader_.fail("mtllib without a file name");
    materials_.add_libraries(words);
  }

  void check_forward() const {
    for (const Forward& reference : forward_) {
      const std::size_t count = reference.to_texture ? textures_.size() : positions_.size();
      const bool ignored = reference.to_texture && count == 0;
      if (!ignored && reference.index >= static_cast<std::int64_t>(count))
        fail_at_line(path_, reference.line,
                     "refers to " + std::string(reference.to_texture ? "texture coordinate " : "vertex ") +
                         std::to_string(reference.index + 1) + "; the file has " + std::to_string(count));
    }
  }

  void build() {
    check_forward();
    FlatMesh& mesh = file_.mesh;
    mesh.textures = std::move(materials_.textures());
    file_.color_scale = color_scale(colors_.largest());
    colors_.apply(positions_.size(), file_.color_scale, mesh.vertex_color);
    mesh.position = std::move(positions_);
    build_faces();
    if (!colors_.empty()) file_.attributes |= vertex_color;
    if (!mesh.edge.empty()) file_.attributes |= edges;
    add_sentences();
  }

  void build_faces() {
    FlatMesh& mesh = file_.mesh;
    mesh.face.reserve(triangles_);
    const bool any_material = std::any_of(faces_.begin(), faces_.end(), [](const Face& f) { return f.material >= 0; });
    const bool any_texture = !textures_.empty() && std::any_of(corners_.begin(), corners_.end(),
                                                               [](const Corner& c) { return c.texture >= 0; });
    bool all_normal = !faces_.empty();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Corner* const corner = corners_.data() + faces_[f].first_corner;
      const std::size_t count =
          (f + 1 < faces_.size() ? faces_[f + 1].first_corner : corners_.size()) - faces_[f].first_corner;
      const bool textured =
          any_texture && std::all_of(corner, corner + count, [](const Corner& c) { return c.texture >= 0; });
      const int material = faces_[f].material;
      if (textured) file_.attributes |= wedge_texture;
      if (material >= 0) file_.attributes |= face_color;
      for (std::size_t k = 0; k < count; ++k) {
        const bool has_one = has_normal(corner[k]);
        if (corner[k].normal != no_normal && !has_one && !normals_.empty()) ++bad_normals_;
        all_normal &= has_one;
      }
      for (std::size_t k = 2; k < count; ++k) {
        const Corner* const own[3] = {&corner[0], &corner[k - 1], &corner[k]};
        mesh.face.push_back({vertex_of(*own[0]), vertex_of(*own[1]), vertex_of(*own[2])});
        for (const Corner* const c : own) set_normal(*c);
        if (any_texture) {
          auto& wedge = mesh.wedge_texture.emplace_back();
          for (std::size_t c = 0; c < 3 && textured; ++c)
            wedge[c] = textures_[static_cast<std::size_t>(own[c]->texture)];
          mesh.face_page.push_back(
              static_cast<std::int16_t>(textured && material >= 0 ? materials_.material(material).page : 0));
        }
        if (any_material)
          mesh.face_color.push_back(material >= 0 ? materials_.material(material).color
                                                  : vcg::Color4b(255, 255, 255, 255));
      }
      note_fan(count, file_);
    }
    if (all_normal) file_.attributes |= vertex_normal;
    if (all_normal) mesh.vertex_normal.resize(mesh.vertices());
  }

  void add_sentences() {
    const std::string name = path_.string() + ": ";
    file_.not_kept = std::move(materials_.problems);
    std::string unknown;
    for (const std::string& statement : unknown_) unknown += (unknown.empty() ? "" : ", ") + statement;
    if (!unknown.empty()) file_.not_kept.push_back(name + "these statements are not kept: " + unknown);
    if (has_split_normals_) file_.not_kept.push_back(name + "normals per corner become normals per vertex");
    note_small_faces(too_small_, path_, file_);
    if (bad_normals_ > 0)
      file_.warnings.push_back(name + std::to_string(bad_normals_) +
                               " corners of faces name a normal that is not there; it is passed over");
  }

  static std::uint32_t vertex_of(const Corner& corner) { return static_cast<std::uint32_t>(corner.vertex); }

  /// The last of several normals counts.
  void set_normal(const Corner& corner) {
    if (!has_normal(corner)) return;
    Points& list = file_.mesh.vertex_normal;
    if (list.empty()) list.resize(file_.mesh.vertices());
    const vcg::Point3d none(0, 0, 0), before = list[vertex_of(corner)],
                                      normal = normals_[static_cast<std::size_t>(corner.normal)];
    has_split_normals_ |= before != none && before != normal;
    list.set(vertex_of(corner), normal);
  }

  bool has_normal(const Corner& corner) const {
    return corner.normal >= 0 && corner.normal < static_cast<std::int64_t>(normals_.size());
  }

  std::filesystem::path path_;
  LineReader reader_;
  FlatFile file_;
  Points positions_;
  std::vector<vcg::Point3d> normals_;
  RawColors colors_;
  std::vector<Texture> textures_;
  std::vector<Face> faces_;
  std::vector<Corner> corners_;  // of all faces
  std::size_t triangles_ = 0;
  std::vector<Forward> forward_;
  ObjMaterials materials_;
  static constexpr std::size_t most_unknown = 20;  // of any bytes there may be many
  std::set<std::string> unknown_;
  std::size_t too_small_ = 0, bad_normals_ = 0;
  bool has_split_normals_ = false;
  int material_ = -1;
};

}  // namespace

FlatFile read_obj(const std::string& bytes, const std::filesystem::path& path) { return ObjReader(bytes, path).read(); }

}  // namespace mesh_tools::io
