// PLY, text and binary in both byte orders. vcglib's reader is not used: it does not check the indices of a polygon's
// last corner, of triangle strips and range grids, trusts what the header says, and reads text slowly.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include <mesh_tools/mesh.h>  // first: the headers of vcglib below need it

#include <vcg/complex/algorithms/create/platonic.h>
#include <vcg/complex/algorithms/update/bounding.h>

#include "formats.h"
#include "ply_data.h"
#include "ply_layout.h"
#include "ply_roles.h"

namespace mesh_tools::io {
namespace {

using Type = PlyLayout::Type;
using Row = PlyData::Row;

Precision precision_of(const PlyLayout::Element& vertex, const std::filesystem::path& path) {
  Type types[3];
  for (int k = 0; k < 3; ++k) {
    const std::string name(1, static_cast<char>('x' + k));
    const auto* property = vertex.find(name);
    if (!property || property->is_list || is_whole(property->type))
      fail(path, "vertex property '" + name + "' must be there and be float or double");
    types[k] = property->type;
  }
  if (types[0] != types[1] || types[0] != types[2]) fail(path, "vertex properties x, y, z must be of one type");
  return types[0] == Type::float32 ? Precision::single_precision : Precision::double_precision;
}

/// vcglib counts textures in 16 bits.
short to_page(double number) {
  return static_cast<short>(
      std::clamp<double>(number, std::numeric_limits<short>::min(), std::numeric_limits<short>::max()));
}

/// What vertices and faces have in common.
template <class Element>
void set(Element& element, Role role, double value) {
  using Quality = std::decay_t<decltype(element.Q())>;
  switch (role) {
    case Role::nx:
    case Role::ny:
    case Role::nz:
      element.N()[static_cast<int>(role) - static_cast<int>(Role::nx)] = value;
      break;
    case Role::flags:
      element.Flags() = static_cast<int>(static_cast<std::int64_t>(value));
      element.ClearD();  // the file holds what there is
      break;
    case Role::quality:
      element.Q() = static_cast<Quality>(value);
      break;
    case Role::red:
    case Role::green:
    case Role::blue:
    case Role::alpha:
      element.C()[static_cast<int>(role) - static_cast<int>(Role::red)] = to_byte(value);
      break;
    default:
      break;
  }
}

void set_vertex(detail::VertexD& vertex, Role role, double value) {
  switch (role) {
    case Role::x:
    case Role::y:
    case Role::z:
      vertex.P()[static_cast<int>(role) - static_cast<int>(Role::x)] = value;
      break;
    case Role::radius:
      vertex.R() = static_cast<float>(value);
      break;
    case Role::gray:
      vertex.C() = vcg::Color4b(to_byte(255 * value), to_byte(255 * value), to_byte(255 * value), 255);
      break;
    case Role::u:
      vertex.T().u() = static_cast<float>(value);
      break;
    case Role::v:
      vertex.T().v() = static_cast<float>(value);
      break;
    default:
      set(vertex, role, value);
  }
}

class PlyReader {
 public:
  PlyReader(const std::string& bytes, const std::filesystem::path& path)
      : path_(path), layout_(parse_ply_header(bytes, path)), data_(bytes, layout_, path) {
    const auto* vertex = layout_.find("vertex");
    if (!vertex) fail(path, "declares no vertices");
    if (vertex->count == 0) fail(path, "holds no vertices");
    file_.precision = precision_of(*vertex, path);
    // Where the file is cut off, reading comes to its end before these are used up, and says where.
    vcg::tri::Allocator<Mesh>::AddVertices(file_.mesh, std::min(vertex->count, data_.most_rows(*vertex)));
  }

  MeshFile read() {
    for (const auto& element : layout_.elements) {
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "edge")
        read_edges(element);
      else if (element.name == "tristrips")
        read_strips(element);
      else if (element.name == "range_grid")
        read_grid(element);
      else
        skip(element);
    }
    read_textures();
    if (!unknown_.empty()) file_.not_kept.push_back(path_.string() + ": these properties are not kept: " + unknown_);
    vcg::tri::UpdateBounding<Mesh>::Box(file_.mesh);
    return std::move(file_);
  }

 private:
  using Element = PlyLayout::Element;

  void add_unknown(const std::string& name) { unknown_ += (unknown_.empty() ? "" : ", ") + printable(name); }

  template <std::size_t N>
  void add_unknown(const Element& element, const KnownProperty (&table)[N],
                   std::initializer_list<std::string_view> lists) {
    for (const auto& property : element.properties) {
      const bool known = property.is_list
                             ? std::find(lists.begin(), lists.end(), property.name) != lists.end()
                             : std::any_of(std::begin(table), std::end(table), [&](const KnownProperty& entry) {
                                 return property.name == entry.name && is_of_kind(property.type, entry.kind);
                               });
      if (!known) add_unknown(element.name + "." + property.name);
    }
  }

  void skip(const Element& element) {
    for (std::size_t i = 0; i < element.count; ++i) data_.read(element, i, row_);
    if (element.count > 0) add_unknown(element.name);
  }

  detail::VertexD* vertex_at(const Element& element, std::size_t row, double index) {
    if (!(index >= 0 && index < file_.mesh.vn))
      data_.fail_at_row(element, row,
                        "has vertex index " + std::to_string(static_cast<std::int64_t>(index)) + "; allowed are 0 to " +
                            std::to_string(file_.mesh.vn - 1));
    return &file_.mesh.vert[static_cast<std::size_t>(index)];
  }

  void read_vertices(const Element& element) {
    const Roles roles(element, known_of_vertex);
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (roles[p] != Role::none) set_vertex(file_.mesh.vert[i], roles[p], row_.number[p]);
    }
    add_unknown(element, known_of_vertex, {});
    const auto add = [&](bool present, int attribute) { file_.attributes |= present ? attribute : 0; };
    add(roles.has_normal(), vertex_normal);
    add(roles.has(Role::flags), vertex_flags);
    add(roles.has(Role::quality), vertex_quality);
    add(roles.has(Role::radius), vertex_radius);
    add(roles.has(Role::red) || roles.has(Role::gray), vertex_color);
    add(roles.has(Role::u) && roles.has(Role::v), vertex_texture);
  }

  detail::FaceD& add_face() {
    ++file_.mesh.fn;
    return file_.mesh.face.emplace_back();
  }

  /// Polygons are cut into fans of triangles.
  void read_faces(const Element& element) {
    if (element.count == 0) return;
    const auto& properties = element.properties;
    const auto list = std::find_if(properties.begin(), properties.end(), is_corner_list);
    if (list == properties.end()) fail(path_, "declares faces without 'vertex_indices', a list of whole numbers");
    const auto texture = std::find_if(properties.begin(), properties.end(), [](const PlyLayout::Property& property) {
      return property.is_list && property.name == "texcoord" && !is_whole(property.type);
    });
    const Roles roles(element, known_of_face);
    const std::vector<double> none;
    std::size_t polygons = 0;
    file_.mesh.face.reserve(
        std::min(element.count, data_.most_rows(element, &*list, 3)));  // the header may say too much
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      const std::vector<double>& corners = row_.list[static_cast<std::size_t>(list - properties.begin())];
      const std::vector<double>& wedges =
          texture == properties.end() ? none : row_.list[static_cast<std::size_t>(texture - properties.begin())];
      if (corners.size() < 3)
        data_.fail_at_row(element, i, "has " + std::to_string(corners.size()) + " vertices; at least 3 are needed");
      if (!wedges.empty() && wedges.size() != 2 * corners.size())
        data_.fail_at_row(element, i,
                          "has " + std::to_string(wedges.size()) + " texture coordinates; allowed are " +
                              std::to_string(2 * corners.size()) + ", two for each corner, and none");
      if (corners.size() > 3) ++polygons;
      for (std::size_t c = 2; c < corners.size(); ++c) {
        detail::FaceD& face = add_face();
        const std::size_t corner[3] = {0, c - 1, c};
        for (int k = 0; k < 3; ++k) {
          face.V(k) = vertex_at(element, i, corners[corner[k]]);
          if (wedges.empty()) continue;
          face.WT(k).u() = static_cast<float>(wedges[2 * corner[k]]);
          face.WT(k).v() = static_cast<float>(wedges[2 * corner[k] + 1]);
        }
        for (std::size_t p = 0; p < properties.size(); ++p) {
          set(face, roles[p], row_.number[p]);
          if (roles[p] != Role::page) continue;
          for (int k = 0; k < 3; ++k) face.WT(k).n() = to_page(row_.number[p]);
        }
      }
    }
    note_polygons(polygons, path_, file_);
    add_unknown(element, known_of_face, {list->name, "texcoord"});
    const auto add = [&](bool present, int attribute) { file_.attributes |= present ? attribute : 0; };
    add(roles.has_normal(), face_normal);
    add(roles.has(Role::flags), face_flags);
    add(roles.has(Role::quality), face_quality);
    add(roles.has(Role::red), face_color);
    add(texture != properties.end(), wedge_texture);
    add(texture != properties.end() && roles.has(Role::page), wedge_texture_index);
  }

  void read_edges(const Element& element) {
    const auto *first = element.find("vertex1"), *second = element.find("vertex2");
    const auto is_index = [](const PlyLayout::Property* property) {
      return property && !property->is_list && is_whole(property->type);
    };
    if (element.count == 0) return;
    if (!is_index(first) || !is_index(second)) return skip(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      detail::EdgeD& edge = file_.mesh.edge.emplace_back();
      ++file_.mesh.en;
      edge.V(0) = vertex_at(element, i, row_.number[static_cast<std::size_t>(first - element.properties.data())]);
      edge.V(1) = vertex_at(element, i, row_.number[static_cast<std::size_t>(second - element.properties.data())]);
    }
    file_.attributes |= edges;
  }

  /// Triangle strips, one behind the other with -1 between them.
  void read_strips(const Element& element) {
    const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
    if (list == element.properties.end()) return skip(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      detail::VertexD *before_last = nullptr, *last = nullptr;
      bool turned = false;
      for (const double index : row_.list[static_cast<std::size_t>(list - element.properties.begin())]) {
        if (index == -1) {
          before_last = last = nullptr;
          turned = false;
          continue;
        }
        detail::VertexD* const vertex = vertex_at(element, i, index);
        if (before_last != nullptr) {
          detail::FaceD& face = add_face();
          face.V(0) = turned ? last : before_last;
          face.V(1) = turned ? before_last : last;
          face.V(2) = vertex;
          turned = !turned;
        }
        before_last = std::exchange(last, vertex);
      }
    }
  }

  /// The number that a comment gives to `name`.
  std::int64_t number_in_comments(std::string_view name) const {
    for (const std::string& comment : layout_.comments)
      if (comment.compare(0, name.size(), name) == 0) return std::atoll(comment.c_str() + name.size());
    return 0;
  }

  /// A scanner's rows and columns, with holes.
  void read_grid(const Element& element) {
    const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
    if (list == element.properties.end()) return skip(element);
    const std::int64_t columns = number_in_comments("num_cols "), rows = number_in_comments("num_rows ");
    const auto count = static_cast<std::int64_t>(element.count);
    const bool fits = columns > 0 && columns <= count && rows > 0 && rows <= count && columns * rows == count;
    if (!fits || file_.mesh.vn > count)
      fail(path_, "its range grid of " + std::to_string(count) +
                      " points must have num_cols times num_rows points and " + "as many as there are vertices");
    std::vector<int> vertex;
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      const std::vector<double>& at = row_.list[static_cast<std::size_t>(list - element.properties.begin())];
      vertex.push_back(at.empty() ? -1 : static_cast<int>(vertex_at(element, i, at[0]) - file_.mesh.vert.data()));
    }
    vcg::tri::SparseFaceGrid(file_.mesh, vertex, static_cast<int>(columns), static_cast<int>(rows));
  }

  void read_textures() {
    constexpr std::string_view keyword = "TextureFile ";
    for (const std::string& comment : layout_.comments)
      if (comment.compare(0, keyword.size(), keyword) == 0)
        file_.mesh.textures.push_back(comment.substr(keyword.size()));
  }

  const std::filesystem::path& path_;
  PlyLayout layout_;
  PlyData data_;
  MeshFile file_;
  Row row_;
  std::string unknown_;
};

}  // namespace

MeshFile read_ply(const std::string& bytes, const std::filesystem::path& path) { return PlyReader(bytes, path).read(); }

namespace {

/// Writes as vcglib's exporter does, by the same names and types. That one is not used, for in double precision it
/// writes texture coordinates of vertices in another type than it declares.
/// Scalar is the type of positions, normals and qualities.
template <class Scalar>
class PlyText {
 public:
  PlyText(const Mesh& mesh, int attributes) : mesh_(mesh), attributes_(attributes) {}

  std::string bytes() {
    append_header();
    std::vector<std::int32_t> number(mesh_.vert.size());
    std::int32_t count = 0;
    for (std::size_t i = 0; i < mesh_.vert.size(); ++i) {
      if (mesh_.vert[i].IsD()) continue;
      number[i] = count++;
      append_vertex(mesh_.vert[i]);
    }
    for (const auto& face : mesh_.face)
      if (!face.IsD()) append_face(face, number);
    for (const auto& edge : mesh_.edge)
      if (has(edges) && !edge.IsD())
        for (int k = 0; k < 2; ++k) append(number[vcg::tri::Index(mesh_, edge.cV(k))]);
    return std::move(bytes_);
  }

 private:
  static constexpr const char* scalar = std::is_same_v<Scalar, float> ? "float" : "double";

  bool has(int attribute) const { return (attributes_ & attribute) != 0; }
  bool has_pages() const { return has(wedge_texture) && mesh_.textures.size() > 1; }

  void declare(const std::string& type, std::initializer_list<const char*> names) {
    for (const char* name : names) bytes_ += "property " + type + " " + name + "\n";
  }

  void append_header() {
    bytes_ = "ply\nformat binary_little_endian 1.0\n";
    if (has(vertex_texture | wedge_texture))
      for (const std::string& texture : mesh_.textures) bytes_ += "comment TextureFile " + texture + "\n";
    bytes_ += "element vertex " + std::to_string(mesh_.vn) + "\n";
    declare(scalar, {"x", "y", "z"});
    if (has(vertex_normal)) declare(scalar, {"nx", "ny", "nz"});
    if (has(vertex_flags)) declare("int", {"flags"});
    if (has(vertex_color)) declare("uchar", {"red", "green", "blue", "alpha"});
    if (has(vertex_quality)) declare(scalar, {"quality"});
    if (has(vertex_radius)) declare("float", {"radius"});
    if (has(vertex_texture)) declare("float", {"texture_u", "texture_v"});
    bytes_ += "element face " + std::to_string(mesh_.fn) + "\n";
    declare("list uchar int", {"vertex_indices"});
    if (has(face_flags)) declare("int", {"flags"});
    if (has(wedge_texture)) declare("list uchar float", {"texcoord"});
    if (has_pages()) declare("int", {"texnumber"});
    if (has(face_color)) declare("uchar", {"red", "green", "blue", "alpha"});
    if (has(face_normal)) declare(scalar, {"nx", "ny", "nz"});
    if (has(face_quality)) declare(scalar, {"quality"});
    if (has(edges)) {
      bytes_ += "element edge " + std::to_string(mesh_.en) + "\n";
      declare("int", {"vertex1", "vertex2"});
    }
    bytes_ += "end_header\n";
  }

  template <class Value>
  void append(Value value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (is_big_endian_machine()) std::reverse(raw, raw + sizeof value);
    bytes_.append(raw, sizeof value);
  }

  template <class Point>
  void append_point(const Point& p) {
    for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(p[k]));
  }

  void append_color(const vcg::Color4b& color) {
    for (int k = 0; k < 4; ++k) append(color[k]);
  }

  void append_vertex(const detail::VertexD& vertex) {
    append_point(vertex.cP());
    if (has(vertex_normal)) append_point(vertex.cN());
    if (has(vertex_flags)) append(static_cast<std::int32_t>(vertex.cFlags()));
    if (has(vertex_color)) append_color(vertex.cC());
    if (has(vertex_quality)) append(static_cast<Scalar>(vertex.cQ()));
    if (has(vertex_radius)) append(static_cast<float>(vertex.cR()));
    if (has(vertex_texture)) {
      append(static_cast<float>(vertex.cT().u()));
      append(static_cast<float>(vertex.cT().v()));
    }
  }

  void append_face(const detail::FaceD& face, const std::vector<std::int32_t>& number) {
    append(static_cast<unsigned char>(3));
    for (int k = 0; k < 3; ++k) append(number[vcg::tri::Index(mesh_, face.cV(k))]);
    if (has(face_flags)) append(static_cast<std::int32_t>(face.cFlags()));
    if (has(wedge_texture)) {
      append(static_cast<unsigned char>(6));
      for (int k = 0; k < 3; ++k) {
        append(static_cast<float>(face.cWT(k).u()));
        append(static_cast<float>(face.cWT(k).v()));
      }
    }
    if (has_pages()) append(static_cast<std::int32_t>(face.cWT(0).n()));
    if (has(face_color)) append_color(face.cC());
    if (has(face_normal)) append_point(face.cN());
    if (has(face_quality)) append(static_cast<Scalar>(face.cQ()));
  }

  const Mesh& mesh_;
  int attributes_;
  std::string bytes_;
};

}  // namespace

std::string ply_bytes(const MeshFile& file) {
  return file.precision == Precision::double_precision ? PlyText<double>(file.mesh, file.attributes).bytes()
                                                       : PlyText<float>(file.mesh, file.attributes).bytes();
}

}  // namespace mesh_tools::io
