// Wavefront OBJ: v (with colour), vt, vn, f, l, and materials for face colour and texture.

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <vcg/complex/algorithms/update/bounding.h>

#include "formats.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

using Words = std::vector<std::string_view>;
using Allocator = vcg::tri::Allocator<Mesh>;

unsigned char to_byte(double fraction) {
  return static_cast<unsigned char>(std::min(255.0, std::max(0.0, fraction * 255 + 0.5)));
}

/// A name that may hold spaces: all but the first word.
std::string rest_of(const Words& words) {
  std::string name(words[1]);
  for (std::size_t i = 2; i < words.size(); ++i) name.append(" ").append(words[i]);
  return name;
}

struct Material {
  std::string name;
  vcg::Color4b color{255, 255, 255, 255};
  int page = 0;  // index into the mesh's textures
};

/// Texture names in the order in which they come first; each has one page.
class TexturePages {
 public:
  int page_of(const std::string& name) {
    const auto [entry, is_new] = page_of_.try_emplace(name, static_cast<int>(names.size()));
    if (is_new) names.push_back(name);
    return entry->second;
  }

  std::vector<std::string> names;

 private:
  std::unordered_map<std::string, int> page_of_;
};

/// What MeshLab takes from a material file: colour, opacity, texture.
std::vector<Material> read_material_file(const std::filesystem::path& path, TexturePages& textures) {
  const std::string text = read_bytes(path);
  LineReader reader(text, path);
  std::vector<Material> materials;
  Words words;
  while (reader.next(words)) {
    if (words.size() < 2) continue;
    if (words[0] == "newmtl") materials.push_back({rest_of(words)});
    if (materials.empty()) continue;
    Material& material = materials.back();
    if (words[0] == "Kd" && words.size() >= 4)
      for (int k = 0; k < 3; ++k) material.color[k] = to_byte(reader.number(words[1 + k]));
    if (words[0] == "d" || words[0] == "Tr") material.color[3] = to_byte(reader.number(words[1]));
    if (words[0] == "map_Kd") material.page = textures.page_of(rest_of(words));
  }
  return materials;
}

class ObjReader {
 public:
  ObjReader(const std::string& text, const std::filesystem::path& path) : path_(path), reader_(text, path) {}

  MeshFile read() {
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
        use_material(words);
      else if (unknown_.size() < most_unknown)
        unknown_.emplace(printable(what));
    }
    build();
    return std::move(file_);
  }

 private:
  struct Corner {
    std::int64_t vertex, texture, normal;  // -1: none
  };
  struct Texture {
    float u, v;
  };
  struct Triangle {
    Corner corner[3];
    int material;
  };

  vcg::Point3d read_point(const Words& words, const char* name) const {
    if (words.size() < 4) reader_.fail(std::string(name) + " has fewer than 3 numbers");
    return {reader_.number(words[1]), reader_.number(words[2]), reader_.number(words[3])};
  }

  void read_vertex(const Words& words) {
    positions_.push_back(read_point(words, "a vertex"));
    if (words.size() < 7) {
      if (!colors_.empty()) colors_.emplace_back(255, 255, 255, 255);
      return;
    }
    colors_.resize(positions_.size() - 1, vcg::Color4b(255, 255, 255, 255));
    double value[3];
    bool fractions = true;
    for (int k = 0; k < 3; ++k) {
      value[k] = reader_.number(words[4 + k]);
      fractions &= value[k] <= 1;
    }
    const double scale = fractions ? 1 : 1.0 / 255;
    colors_.emplace_back(to_byte(value[0] * scale), to_byte(value[1] * scale), to_byte(value[2] * scale), 255);
  }

  Texture read_texture(const Words& words) const {
    if (words.size() < 3) reader_.fail("a texture coordinate has fewer than 2 numbers");
    return {static_cast<float>(reader_.number(words[1])), static_cast<float>(reader_.number(words[2]))};
  }

  /// Index from 1, or from -1 backwards, to an index from 0.
  std::int64_t index(std::string_view word, std::size_t count, const char* name) const {
    const std::int64_t given = reader_.integer(word), size = static_cast<std::int64_t>(count);
    const std::int64_t result = given < 0 ? size + given : given - 1;
    if (given == 0 || result < 0 || result >= size)
      reader_.fail("refers to " + std::string(name) + " " + printable(word) + "; before this line there are " +
                   std::to_string(count));
    return result;
  }

  Corner read_corner(std::string_view word) const {
    const std::size_t first = word.find('/'), second = first == word.npos ? word.npos : word.find('/', first + 1);
    Corner corner{index(word.substr(0, first), positions_.size(), "vertex"), -1, -1};
    if (first == word.npos) return corner;
    const std::string_view texture = word.substr(first + 1, second == word.npos ? word.npos : second - first - 1);
    // Files from which all texture coordinates or normals were removed are common, and faces refer to them still.
    if (!texture.empty() && !textures_.empty()) corner.texture = index(texture, textures_.size(), "texture coordinate");
    if (second != word.npos && second + 1 < word.size() && !normals_.empty())
      corner.normal = index(word.substr(second + 1), normals_.size(), "vertex normal");
    return corner;
  }

  void read_face(const Words& words) {
    if (words.size() < 4) reader_.fail("a face has fewer than 3 vertices");
    std::vector<Corner> corners;
    for (std::size_t i = 1; i < words.size(); ++i) corners.push_back(read_corner(words[i]));
    if (corners.size() > 3) ++polygons_;
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles_.push_back({{corners[0], corners[i - 1], corners[i]}, material_});
  }

  void read_line(const Words& words) {
    for (std::size_t i = 2; i < words.size(); ++i)
      edges_.emplace_back(read_corner(words[i - 1]).vertex, read_corner(words[i]).vertex);
  }

  void read_materials(const Words& words) {
    if (words.size() < 2) reader_.fail("mtllib without a file name");
    const std::filesystem::path library = path_.parent_path() / rest_of(words);
    try {
      for (Material& material : read_material_file(library, pages_)) {
        material_of_[material.name] = static_cast<int>(materials_.size());  // of several with one name the last counts
        materials_.push_back(std::move(material));
      }
    } catch (const FileError& error) {
      file_.not_kept.push_back(std::string(error.what()) + " (colours and textures are lost)");
    }
  }

  void use_material(const Words& words) {
    material_ = -1;
    if (words.size() < 2) return;
    const auto known = material_of_.find(rest_of(words));
    if (known != material_of_.end()) material_ = known->second;
  }

  void build() {
    Mesh& mesh = file_.mesh;
    mesh.textures = std::move(pages_.names);
    if (!positions_.empty()) Allocator::AddVertices(mesh, positions_.size());
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      mesh.vert[i].P() = positions_[i];
      if (!colors_.empty()) mesh.vert[i].C() = colors_[i];
    }
    if (!triangles_.empty()) Allocator::AddFaces(mesh, triangles_.size());
    bool all_textured = !triangles_.empty(), all_normal = !triangles_.empty();
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      fill_face(triangles_[i], mesh.face[i], all_textured, all_normal);
    for (const auto& [a, b] : edges_) {
      auto edge = Allocator::AddEdges(mesh, 1);
      edge->V(0) = &mesh.vert[a];
      edge->V(1) = &mesh.vert[b];
    }
    if (!colors_.empty()) file_.attributes |= vertex_color;
    if (all_normal) file_.attributes |= vertex_normal;
    if (all_textured) file_.attributes |= wedge_texture;
    if (!edges_.empty()) file_.attributes |= edges;
    if (!all_textured && !textures_.empty())
      file_.not_kept.push_back(path_.string() + ": not every face has texture coordinates; they are not kept");
    std::string unknown;
    for (const std::string& statement : unknown_) unknown += (unknown.empty() ? "" : ", ") + statement;
    if (!unknown.empty()) file_.not_kept.push_back(path_.string() + ": these statements are not kept: " + unknown);
    if (has_split_normals_) file_.not_kept.push_back(path_.string() + ": normals per corner become normals per vertex");
    note_polygons(polygons_, path_, file_);
    vcg::tri::UpdateBounding<Mesh>::Box(mesh);
  }

  /// The last of several normals counts.
  void set_normal(detail::VertexD& vertex, const vcg::Point3d& normal) {
    const vcg::Point3d none(0, 0, 0);
    has_split_normals_ |= vertex.cN() != none && vertex.cN() != normal;
    vertex.N() = normal;
  }

  void fill_face(const Triangle& triangle, detail::FaceD& face, bool& all_textured, bool& all_normal) {
    const bool has_material = triangle.material >= 0;
    for (int k = 0; k < 3; ++k) {
      const Corner& corner = triangle.corner[k];
      face.V(k) = &file_.mesh.vert[corner.vertex];
      all_normal &= corner.normal >= 0;
      all_textured &= corner.texture >= 0;
      if (corner.normal >= 0) set_normal(*face.V(k), normals_[corner.normal]);
      if (corner.texture < 0) continue;
      face.WT(k).u() = textures_[corner.texture].u;
      face.WT(k).v() = textures_[corner.texture].v;
      face.WT(k).n() = static_cast<short>(has_material ? materials_[triangle.material].page : 0);
    }
    if (!has_material) {
      face.C() = vcg::Color4b(255, 255, 255, 255);
      return;
    }
    face.C() = materials_[triangle.material].color;
    file_.attributes |= face_color;
  }

  std::filesystem::path path_;
  LineReader reader_;
  MeshFile file_;
  std::vector<vcg::Point3d> positions_, normals_;
  std::vector<vcg::Color4b> colors_;
  std::vector<Texture> textures_;
  std::vector<Triangle> triangles_;
  std::vector<std::pair<std::int64_t, std::int64_t>> edges_;
  std::vector<Material> materials_;
  std::unordered_map<std::string, int> material_of_;  // index in materials_ by name
  TexturePages pages_;
  static constexpr std::size_t most_unknown = 20;  // of any bytes there may be many
  std::set<std::string> unknown_;
  std::size_t polygons_ = 0;
  bool has_split_normals_ = false;
  int material_ = -1;
};

/// Colour and texture of a face, as the material file names them.
struct FaceMaterial {
  std::array<unsigned char, 4> color;
  std::string texture;

  bool operator<(const FaceMaterial& other) const {
    return std::tie(color, texture) < std::tie(other.color, other.texture);
  }
};

/// Scalar is what positions and normals are rounded to.
template <class Scalar>
class ObjText {
 public:
  ObjText(const Mesh& mesh, int attributes) : mesh_(mesh), attributes_(attributes) {}

  std::map<FaceMaterial, std::size_t> materials;

  std::string text(const std::string& material_name) {
    const bool has_materials = attributes_ & (face_color | wedge_texture);
    if (has_materials) text_ += "mtllib " + material_name + "\n";
    append_vertices();
    std::size_t current = mesh_.face.size();  // none: there are never more materials than faces
    for (const auto& face : mesh_.face) {
      if (face.IsD()) continue;
      if (has_materials) {
        const std::size_t material = materials.try_emplace(material_of(face), materials.size()).first->second;
        if (material != current) text_ += "usemtl material_" + std::to_string(material) + "\n";
        current = material;
      }
      append_face(face);
    }
    for (const auto& edge : mesh_.edge)
      if (!edge.IsD() && (attributes_ & edges))
        text_ += "l " + std::to_string(number_[vcg::tri::Index(mesh_, edge.cV(0))]) + " " +
                 std::to_string(number_[vcg::tri::Index(mesh_, edge.cV(1))]) + "\n";
    return std::move(text_);
  }

 private:
  FaceMaterial material_of(const detail::FaceD& face) const {
    FaceMaterial material{{255, 255, 255, 255}, {}};
    if (attributes_ & face_color)
      for (int k = 0; k < 4; ++k) material.color[k] = face.cC()[k];
    const int page = face.cWT(0).n();
    if ((attributes_ & wedge_texture) && page >= 0 && static_cast<std::size_t>(page) < mesh_.textures.size())
      material.texture = mesh_.textures[page];
    return material;
  }

  void append(double value) { append_number(text_ += ' ', value); }

  void append_vertices() {
    number_.resize(mesh_.vert.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh_.vert.size(); ++i) {
      const auto& vertex = mesh_.vert[i];
      if (vertex.IsD()) continue;
      number_[i] = ++count;
      text_ += 'v';
      for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(vertex.cP()[k]));
      if (attributes_ & vertex_color)
        for (int k = 0; k < 3; ++k) append(vertex.cC()[k] / 255.0);
      text_ += '\n';
      if (!(attributes_ & vertex_normal)) continue;
      text_ += "vn";
      for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(vertex.cN()[k]));
      text_ += '\n';
    }
  }

  void append_face(const detail::FaceD& face) {
    const bool textured = attributes_ & wedge_texture, normals = attributes_ & vertex_normal;
    std::size_t texture[3] = {};
    for (int k = 0; k < 3 && textured; ++k) {
      const auto [entry, is_new] = textures_.try_emplace({face.cWT(k).u(), face.cWT(k).v()}, textures_.size() + 1);
      texture[k] = entry->second;
      if (!is_new) continue;
      text_ += "vt";
      append(face.cWT(k).u());
      append(face.cWT(k).v());
      text_ += '\n';
    }
    text_ += 'f';
    for (int k = 0; k < 3; ++k) {
      const std::string vertex = std::to_string(number_[vcg::tri::Index(mesh_, face.cV(k))]);
      text_.append(" ").append(vertex);
      if (textured || normals) text_ += '/';
      if (textured) text_ += std::to_string(texture[k]);
      if (normals) text_.append("/").append(vertex);
    }
    text_ += '\n';
  }

  const Mesh& mesh_;
  int attributes_;
  std::string text_;
  std::vector<std::size_t> number_;
  std::map<std::pair<float, float>, std::size_t> textures_;
};

std::string material_text(const std::map<FaceMaterial, std::size_t>& materials) {
  std::string text;
  for (const auto& [material, number] : materials) {
    text += "newmtl material_" + std::to_string(number) + "\nKd";
    for (int k = 0; k < 3; ++k) append_number(text += ' ', material.color[k] / 255.0);
    append_number(text += "\nd ", material.color[3] / 255.0);
    text += '\n';
    if (!material.texture.empty()) text += "map_Kd " + material.texture + "\n";
  }
  return text;
}

template <class Scalar>
ObjBytes bytes_of(const MeshFile& file, const std::string& material_name) {
  ObjText<Scalar> obj(file.mesh, file.attributes);
  std::string mesh = obj.text(material_name);
  return {std::move(mesh), material_text(obj.materials)};
}

}  // namespace

MeshFile read_obj(const std::string& bytes, const std::filesystem::path& path) { return ObjReader(bytes, path).read(); }

ObjBytes obj_bytes(const MeshFile& file, const std::string& material_name) {
  return file.precision == Precision::double_precision ? bytes_of<double>(file, material_name)
                                                       : bytes_of<float>(file, material_name);
}

}  // namespace mesh_tools::io
