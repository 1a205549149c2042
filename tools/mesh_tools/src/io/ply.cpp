// SPDX-License-Identifier: GPL-3.0-or-later
// PLY, text and binary in both byte orders. vcglib's reader is not used: it does not check the indices of a polygon's
// last corner, of triangle strips and range grids, trusts what the header says, and reads text slowly.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>

#include "colors.h"
#include "formats.h"
#include "large_pages.h"
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

const vcg::Color4b white(255, 255, 255, 255);

bool is_normal(Role role) { return role == Role::nx || role == Role::ny || role == Role::nz; }
bool is_color(Role role) {
  return role == Role::red || role == Role::green || role == Role::blue || role == Role::alpha;
}
/// The number of a role among those that belong together, which begin with `first`.
int part(Role role, Role first) { return static_cast<int>(role) - static_cast<int>(first); }

/// vcglib's bits; the file holds what there is.
std::int32_t to_flags(double number) {
  constexpr std::int32_t deleted = 1;
  return static_cast<std::int32_t>(static_cast<std::int64_t>(number)) & ~deleted;
}

/// The precision that holds all numbers of these properties.
Precision precision_of(const PlyLayout::Element& element, const Roles& roles, bool (*is_one)(Role)) {
  for (std::size_t p = 0; p < element.properties.size(); ++p)
    if (is_one(roles[p]) && element.properties[p].type == Type::float64) return Precision::double_precision;
  return Precision::single_precision;
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
    vertices_ = std::min(vertex->count, data_.most_rows(*vertex));
    file_.mesh.position = Points(file_.precision);
    file_.mesh.position.resize(vertices_);
  }

  FlatFile read() {
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
    complete_faces();
    // Faces that are none are likely where data are read from the wrong place on.
    if (has_small_faces_ && !is_text() && data_.bytes_left() > 0)
      fail(path_, "has faces of fewer than 3 vertices, and " + std::to_string(data_.bytes_left()) +
                      " bytes behind its data: its counts are wrong");
    for (const std::string_view name : texture_names(layout_)) file_.mesh.textures.emplace_back(name);
    for (const std::string& warning : layout_.warnings) file_.warnings.push_back(path_.string() + ": " + warning);
    if (!unknown_.empty()) file_.not_kept.push_back(path_.string() + ": these properties are not kept: " + unknown_);
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
    if (element.count == 0) return;
    if (data_.has_fixed_rows(element))
      data_.take_fixed_rows(element);
    else
      for (std::size_t i = 0; i < element.count; ++i) data_.read(element, i, row_);
    add_unknown(element.name);
  }

  std::uint32_t vertex_at(const Element& element, std::size_t row, double index) {
    if (!(index >= 0 && index < static_cast<double>(vertices_)))
      data_.fail_at_row(element, row,
                        "has vertex index " + std::to_string(static_cast<std::int64_t>(index)) + "; allowed are 0 to " +
                            std::to_string(static_cast<std::int64_t>(vertices_) - 1));
    return static_cast<std::uint32_t>(index);
  }

  void add(bool present, int attribute) { file_.attributes |= present ? attribute : 0; }

  void read_vertices(const Element& element) {
    const Roles roles(element, known_of_vertex);
    make_room(element, roles);
    RawColors wide;
    const auto take = [&](std::size_t p, std::size_t i, double number) {
      if (is_wide_color(roles[p], element.properties[p]))
        wide.add(i, part(roles[p], Role::red), number);
      else
        set_vertex(i, roles[p], number);
    };
    const bool any_wide = has_wide_colors(element, roles);
    if (data_.has_fixed_rows(element) && !any_wide) {
      const PlyData::FixedRows rows = data_.take_fixed_rows(element);
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (roles[p] != Role::none)
          data_.visit_numbers(element, p, rows, [&](std::size_t i, double number) { set_vertex(i, roles[p], number); });
    } else {
      for (std::size_t i = 0; i < element.count; ++i) {
        data_.read(element, i, row_);
        for (std::size_t p = 0; p < element.properties.size(); ++p)
          if (roles[p] != Role::none) take(p, i, row_.number[p]);
      }
    }
    if (!wide.empty()) file_.color_scale = scale_of(wide, has_whole_colors(element, roles));
    wide.apply(vertices_, file_.color_scale, file_.mesh.vertex_color);
    add_unknown(element, roles, {});
    add(roles.has_normal(), vertex_normal);
    add(roles.has(Role::flags), vertex_flags);
    add(roles.has(Role::quality), vertex_quality);
    add(roles.has(Role::radius), vertex_radius);
    add(roles.has(Role::red) || roles.has(Role::gray), vertex_color);
    add(roles.has(Role::u) && roles.has(Role::v), vertex_texture);
  }

  /// For all that a vertex has besides its place.
  void make_room(const Element& element, const Roles& roles) {
    FlatMesh& mesh = file_.mesh;
    if (roles.has(Role::nx) || roles.has(Role::ny) || roles.has(Role::nz)) {
      mesh.vertex_normal = Points(precision_of(element, roles, is_normal));
      mesh.vertex_normal.resize(vertices_);
    }
    if (roles.has(Role::flags)) mesh.vertex_flags.resize(vertices_);
    if (roles.has(Role::quality)) mesh.vertex_quality.resize(vertices_);
    if (roles.has(Role::radius)) mesh.vertex_radius.resize(vertices_);
    if (has_colors(roles) || roles.has(Role::gray)) mesh.vertex_color.resize(vertices_, white);
    if (roles.has(Role::u) || roles.has(Role::v)) mesh.vertex_texture.resize(vertices_, {0, 0});
  }

  void set_vertex(std::size_t i, Role role, double value) {
    FlatMesh& mesh = file_.mesh;
    switch (role) {
      case Role::x:
      case Role::y:
      case Role::z:
        mesh.position.set(i, part(role, Role::x), value);
        break;
      case Role::nx:
      case Role::ny:
      case Role::nz:
        mesh.vertex_normal.set(i, part(role, Role::nx), value);
        break;
      case Role::flags:
        mesh.vertex_flags[i] = to_flags(value);
        break;
      case Role::quality:
        mesh.vertex_quality[i] = value;
        break;
      case Role::radius:
        mesh.vertex_radius[i] = static_cast<float>(value);
        break;
      case Role::red:
      case Role::green:
      case Role::blue:
      case Role::alpha:
        mesh.vertex_color[i][part(role, Role::red)] = color_byte(value);
        break;
      case Role::gray: {
        const unsigned char gray = color_byte(255 * value);
        mesh.vertex_color[i] = vcg::Color4b(gray, gray, gray, 255);
        break;
      }
      case Role::u:
        mesh.vertex_texture[i].u = static_cast<float>(value);
        break;
      case Role::v:
        mesh.vertex_texture[i].v = static_cast<float>(value);
        break;
      default:
        break;
    }
  }

  static bool has_colors(const Roles& roles) {
    return roles.has(Role::red) || roles.has(Role::green) || roles.has(Role::blue) || roles.has(Role::alpha);
  }
  static bool is_wide_color(Role role, const PlyLayout::Property& property) {
    return is_color(role) && property.type != Type::uint8;
  }
  static bool has_wide_colors(const Element& element, const Roles& roles, bool whole_ones = false) {
    for (std::size_t p = 0; p < element.properties.size(); ++p)
      if (is_wide_color(roles[p], element.properties[p]) && (!whole_ones || is_whole(element.properties[p].type)))
        return true;
    return false;
  }
  static bool has_whole_colors(const Element& element, const Roles& roles) {
    return has_wide_colors(element, roles, true);
  }

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
    FlatMesh& mesh = file_.mesh;
    RawColors wide;
    std::size_t too_small = 0;
    // The header may say too much.
    reserve_in_large_pages(mesh.face, std::min(element.count, data_.most_rows(element, &*list, 3)));
    if (roles.has(Role::nx) || roles.has(Role::ny) || roles.has(Role::nz))
      mesh.face_normal = Points(precision_of(element, roles, is_normal));
    data_.expect_triangles(element);
    const auto limit = static_cast<std::uint32_t>(vertices_);
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < element.count; ++i) {
      if (data_.take_triangle(element, limit, triangle)) {
        mesh.face.push_back(triangle);
        continue;
      }
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
        const std::size_t corner[3] = {0, c - 1, c};
        for (std::size_t k = 0; k < 3; ++k) triangle[k] = vertex_at(element, i, corners[corner[k]]);
        mesh.face.push_back(triangle);
        if (texture != properties.end()) {
          mesh.wedge_texture.resize(mesh.face.size());
          auto& wedge = mesh.wedge_texture.back();
          for (std::size_t k = 0; k < 3 && !wedges.empty(); ++k)
            wedge[k] = {static_cast<float>(wedges[2 * corner[k]]), static_cast<float>(wedges[2 * corner[k] + 1])};
        }
        add_face_numbers(element, roles, wide);
      }
      note_fan(corners.size(), file_);
    }
    wide.apply(mesh.face.size(), scale_of(wide, has_whole_colors(element, roles)), mesh.face_color);
    note_small_faces(too_small, path_, file_);
    has_small_faces_ = too_small > 0;
    add_unknown(element, roles, {list->name, "texcoord"});
    add(roles.has_normal(), face_normal);
    add(roles.has(Role::flags), face_flags);
    add(roles.has(Role::quality), face_quality);
    add(roles.has(Role::red), face_color);
    add(texture != properties.end(), wedge_texture);
    add(texture != properties.end() && roles.has(Role::page), wedge_texture_index);
  }

  /// All that a face has besides its corners, from its row; of a polygon each triangle.
  void add_face_numbers(const Element& element, const Roles& roles, RawColors& wide) {
    FlatMesh& mesh = file_.mesh;
    const std::size_t f = mesh.face.size() - 1;
    const auto put = [f](auto& list, auto number) {
      list.resize(std::max(list.size(), f + 1));  // faces of strips have nothing of this
      list[f] = number;
    };
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const double value = row_.number[p];
      if (is_wide_color(roles[p], element.properties[p])) {
        wide.add(f, part(roles[p], Role::red), value);
      } else if (is_color(roles[p])) {
        mesh.face_color.resize(f + 1, white);
        mesh.face_color[f][part(roles[p], Role::red)] = color_byte(value);
      } else if (is_normal(roles[p])) {
        mesh.face_normal.resize(f + 1);
        mesh.face_normal.set(f, part(roles[p], Role::nx), value);
      } else if (roles[p] == Role::flags) {
        put(mesh.face_flags, to_flags(value));
      } else if (roles[p] == Role::quality) {
        put(mesh.face_quality, value);
      } else if (roles[p] == Role::page) {
        put(mesh.face_page, to_page(value));
      }
    }
  }

  /// Gives the faces of strips and grids what other faces have.
  void complete_faces() {
    FlatMesh& mesh = file_.mesh;
    const std::size_t faces = mesh.face.size();
    const auto has = [this](int attribute) { return (file_.attributes & attribute) != 0; };
    if (has(face_color)) mesh.face_color.resize(faces, white);
    if (has(face_normal)) mesh.face_normal.resize(faces);
    if (has(face_flags)) mesh.face_flags.resize(faces);
    if (has(face_quality)) mesh.face_quality.resize(faces);
    if (has(wedge_texture)) mesh.wedge_texture.resize(faces);
    if (!mesh.face_page.empty()) mesh.face_page.resize(faces);
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
      const auto end = [&](const PlyLayout::Property* property) {
        return vertex_at(element, i, row_.number[static_cast<std::size_t>(property - element.properties.data())]);
      };
      const std::uint32_t start = end(first);
      file_.mesh.edge.push_back({start, end(second)});
    }
    file_.attributes |= edges;
  }

  /// Triangle strips, one behind the other with -1 between them.
  void read_strips(const Element& element) {
    const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
    if (list == element.properties.end()) return skip(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      constexpr std::int64_t nothing = -1;
      std::int64_t before_last = nothing, last = nothing;
      bool turned = false;
      for (const double index : row_.list[static_cast<std::size_t>(list - element.properties.begin())]) {
        if (index == -1) {
          before_last = last = nothing;
          turned = false;
          continue;
        }
        const std::uint32_t vertex = vertex_at(element, i, index);
        if (before_last != nothing) {
          const auto a = static_cast<std::uint32_t>(before_last), b = static_cast<std::uint32_t>(last);
          file_.mesh.face.push_back({turned ? b : a, turned ? a : b, vertex});
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
    if (!fits || static_cast<std::int64_t>(vertices_) > count)
      fail(path_, "its range grid of " + std::to_string(count) +
                      " points must have num_cols times num_rows points and " + "as many as there are vertices");
    std::vector<std::int64_t> vertex;
    for (std::size_t i = 0; i < element.count; ++i) {
      data_.read(element, i, row_);
      const std::vector<double>& at = row_.list[static_cast<std::size_t>(list - element.properties.begin())];
      vertex.push_back(at.empty() ? -1 : static_cast<std::int64_t>(vertex_at(element, i, at[0])));
    }
    add_grid(vertex, columns, rows);
  }

  /// Two triangles between four points of a grid, as vcglib cuts them, and one where one of the points is missing.
  void add_grid(const std::vector<std::int64_t>& vertex, std::int64_t columns, std::int64_t rows) {
    const auto add = [this](std::int64_t a, std::int64_t b, std::int64_t c) {
      if (a < 0 || b < 0 || c < 0) return false;
      file_.mesh.face.push_back(
          {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
      return true;
    };
    for (std::int64_t row = 0; row + 1 < rows; ++row)
      for (std::int64_t column = 0; column + 1 < columns; ++column) {
        const auto* const above = vertex.data() + row * columns + column;
        const auto* const below = above + columns;
        const bool has_first = add(below[1], below[0], above[0]), has_second = add(above[0], above[1], below[1]);
        if (has_first || has_second) continue;  // the other diagonal
        add(below[0], above[0], above[1]);
        add(above[1], below[1], below[0]);
      }
  }

  const std::filesystem::path& path_;
  PlyLayout layout_;
  PlyData data_;
  FlatFile file_;
  Row row_;
  std::size_t vertices_ = 0;
  bool has_small_faces_ = false;
  std::string unknown_;
};

}  // namespace

FlatFile read_ply(const std::string& bytes, const std::filesystem::path& path) { return PlyReader(bytes, path).read(); }

}  // namespace mesh_tools::io
