// SPDX-License-Identifier: GPL-3.0-or-later
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

#include "colors.h"
#include "formats.h"
#include "ply_data.h"
#include "ply_layout.h"
#include "ply_roles.h"
#include "polygons.h"

namespace mesh_tools::io {
namespace {

using Type = PlyLayout::Type;
using Row = PlyData::Row;

/// Single if it holds every number that the coordinates can be.
Precision precision_of(const PlyLayout::Element& vertex, const std::filesystem::path& path) {
  Precision precision = Precision::single_precision;
  for (const char* name : {"x", "y", "z"}) {
    const auto* property = vertex.find(name);
    if (!property || property->is_list)
      fail(path, std::string("vertex property '") + name + "' must be there and be a number");
    const bool fits = property->type == Type::float32 || size_of(property->type) < sizeof(float);
    if (!fits) precision = Precision::double_precision;
  }
  return precision;
}

/// What makes colour components of another type than bytes 0 to 255.
double scale_of(const RawColors& colors, bool whole) {
  if (!whole) return color_scale(colors.largest());
  if (colors.largest() <= 255) return 1;
  return 255 / (colors.largest() <= 65535 ? 65535.0 : 4294967295.0);
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
      element.C()[static_cast<int>(role) - static_cast<int>(Role::red)] = color_byte(value);
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
      vertex.C() = vcg::Color4b(color_byte(255 * value), color_byte(255 * value), color_byte(255 * value), 255);
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
    // Faces that are none are likely where data are read from the wrong place on.
    if (has_small_faces_ && !is_text() && data_.bytes_left() > 0)
      fail(path_, "has faces of fewer than 3 vertices, and " + std::to_string(data_.bytes_left()) +
                      " bytes behind its data: its counts are wrong");
    for (const std::string_view name : texture_names(layout_)) file_.mesh.textures.emplace_back(name);
    for (const std::string& warning : layout_.warnings) file_.warnings.push_back(path_.string() + ": " + warning);
    if (!unknown_.empty()) file_.not_kept.push_back(path_.string() + ": these properties are not kept: " + unknown_);
    vcg::tri::UpdateBounding<Mesh>::Box(file_.mesh);
    return std::move(file_);
  }

 private:
  using Element = PlyLayout::Element;

  bool is_text() const { return layout_.format == PlyLayout::Format::ascii; }

  void add_unknown(const std::string& name) { unknown_ += (unknown_.empty() ? "" : ", ") + printable(name); }

  /// @param lists  names of lists that are known
  void add_unknown(const Element& element, const Roles& roles, std::initializer_list<std::string_view> lists) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const auto& property = element.properties[p];
      const bool known = property.is_list ? std::find(lists.begin(), lists.end(), property.name) != lists.end()
                                          : roles[p] != Role::none;
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
    RawColors wide;
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (is_wide_color(roles[p], element.properties[p]))
          wide.add(i, component(roles[p]), row_.number[p]);
        else if (roles[p] != Role::none)
          set_vertex(file_.mesh.vert[i], roles[p], row_.number[p]);
    }
    if (!wide.empty()) file_.color_scale = scale_of(wide, has_whole_colors(element, roles));
    wide.apply(file_.mesh.vert, file_.color_scale);
    add_unknown(element, roles, {});
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

  static bool is_color(Role role) {
    return role == Role::red || role == Role::green || role == Role::blue || role == Role::alpha;
  }
  static bool is_wide_color(Role role, const PlyLayout::Property& property) {
    return is_color(role) && property.type != Type::uint8;
  }
  static bool has_whole_colors(const Element& element, const Roles& roles) {
    for (std::size_t p = 0; p < element.properties.size(); ++p)
      if (is_wide_color(roles[p], element.properties[p]) && is_whole(element.properties[p].type)) return true;
    return false;
  }
  static int component(Role role) { return static_cast<int>(role) - static_cast<int>(Role::red); }

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
    RawColors wide;
    std::size_t too_small = 0;
    file_.mesh.face.reserve(
        std::min(element.count, data_.most_rows(element, &*list, 3)));  // the header may say too much
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      const std::vector<double>& corners = row_.list[static_cast<std::size_t>(list - properties.begin())];
      const std::vector<double>& wedges =
          texture == properties.end() ? none : row_.list[static_cast<std::size_t>(texture - properties.begin())];
      if (corners.size() < 3) {
        // Within a line, or where zeros are read as one, it is what the file's counts do not fit.
        if (is_text() ? !data_.row_begins_line() : corners.empty())
          data_.fail_at_row(element, i, "has " + std::to_string(corners.size()) + " vertices; at least 3 are needed");
        for (const double index : corners) vertex_at(element, i, index);
        ++too_small;
        continue;
      }
      if (!wedges.empty() && wedges.size() != 2 * corners.size())
        data_.fail_at_row(element, i,
                          "has " + std::to_string(wedges.size()) + " texture coordinates; allowed are " +
                              std::to_string(2 * corners.size()) + ", two for each corner, and none");
      for (std::size_t c = 2; c < corners.size(); ++c) {
        detail::FaceD& face = add_face();
        const std::size_t corner[3] = {0, c - 1, c};
        for (int k = 0; k < 3; ++k) {
          face.V(k) = vertex_at(element, i, corners[corner[k]]);
          if (wedges.empty()) continue;
          face.WT(k).u() = static_cast<float>(wedges[2 * corner[k]]);
          face.WT(k).v() = static_cast<float>(wedges[2 * corner[k] + 1]);
        }
        if (wedges.empty()) set_untextured(face);
        for (std::size_t p = 0; p < properties.size(); ++p) {
          if (is_wide_color(roles[p], properties[p]))
            wide.add(file_.mesh.face.size() - 1, component(roles[p]), row_.number[p]);
          else
            set(face, roles[p], row_.number[p]);
          if (roles[p] != Role::page) continue;
          for (int k = 0; k < 3; ++k) face.WT(k).n() = to_page(row_.number[p]);
        }
      }
      note_fan(corners.size(), file_);
    }
    wide.apply(file_.mesh.face, scale_of(wide, has_whole_colors(element, roles)));
    note_small_faces(too_small, path_, file_);
    has_small_faces_ = too_small > 0;
    add_unknown(element, roles, {list->name, "texcoord"});
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
    for (const std::string_view comment : layout_.comments)
      if (comment.substr(0, name.size()) == name) return std::atoll(std::string(comment.substr(name.size())).c_str());
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

  const std::filesystem::path& path_;
  PlyLayout layout_;
  PlyData data_;
  MeshFile file_;
  Row row_;
  bool has_small_faces_ = false;
  std::string unknown_;
};

}  // namespace

MeshFile read_ply(const std::string& bytes, const std::filesystem::path& path) { return PlyReader(bytes, path).read(); }

}  // namespace mesh_tools::io
