// SPDX-License-Identifier: GPL-3.0-or-later
#include "splice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "../colors.h"
#include "../file_names.h"
#include "../formats.h"
#include "../ply_data.h"
#include "../ply_roles.h"
#include "moved_normals.h"
#include "text_splicer.h"

namespace mesh_tools::io {
namespace {

using Type = PlyLayout::Type;
using Element = PlyLayout::Element;
using vcg::Point3d;

/// A number as a property of this type holds it.
double as_stored(double value, Type type) {
  return type == Type::float32 ? static_cast<double>(static_cast<float>(value)) : value;
}

[[noreturn]] void refuse_whole_numbers() {
  throw NoRoom("its coordinates are whole numbers; those of the result are not, so it is written anew");
}

/// Puts numbers in the place of others: text into a copy, binary numbers into the bytes themselves.
class PlyNumbers {
 public:
  PlyNumbers(std::string& bytes, PlyLayout::Format format, const Write& write)
      : bytes_(bytes),
        format_(format),
        is_text_(format == PlyLayout::Format::ascii),
        write_(write),
        text_(is_text_ ? std::string_view(bytes) : std::string_view(), write) {}

  /// @param raw  the number's bytes in the file
  void replace(std::string_view raw, Type type, double before, double now) {
    switch (type) {
      case Type::float32:
        return put(raw, static_cast<float>(before), static_cast<float>(now));
      case Type::float64:
        return put(raw, before, now);
      default:
        return put_whole(raw, type, before, now);
    }
  }

  /// Puts now(i) in the place of the i-th of numbers at equal distances, all of one type, of a binary file.
  /// @param first  where the first one is in the file
  /// @throws NoRoom  it would have to become another one, and they are whole numbers
  template <class Number, class Now>
  void replace_all(const char* first, std::size_t stride, std::size_t count, Number /*type*/, const Now& now) {
    char* at = bytes_.data() + (first - bytes_.data());
    const bool swapped = is_swapped();
    for (std::size_t i = 0; i < count; ++i, at += stride) {
      const auto before = number_at<Number>(at, swapped);
      const double wanted = now(i);
      if constexpr (std::is_integral_v<Number>) {
        if (static_cast<double>(before) != wanted) refuse_whole_numbers();
      } else {
        const auto number = static_cast<Number>(wanted);
        if (is_same_number(before, number)) continue;
        put_number(at, number, swapped);
      }
    }
  }

  /// Puts a text in the place of another in the header; to be called before all numbers are replaced, from its
  /// beginning to its end.
  void replace_in_header(std::string_view text, const std::string& by) {
    if (is_text_) return text_.replace(text, by);
    header_.emplace_back(static_cast<std::size_t>(text.data() - bytes_.data()), text.size(), by);
  }

  void finish() {
    if (is_text_) return text_.finish();
    for (auto change = header_.rbegin(); change != header_.rend(); ++change)
      bytes_.replace(std::get<0>(*change), std::get<1>(*change), std::get<2>(*change));
    write_(bytes_);
  }

 private:
  template <class Real>
  void put(std::string_view raw, Real before, Real now) {
    if (is_text_) return text_.replace_number(raw, before, now);
    if (!is_same_number(before, now)) put_binary(raw, now);
  }

  void put_whole(std::string_view raw, Type type, double before, double now) {
    const auto number = static_cast<std::uint32_t>(std::llround(now));
    if (static_cast<double>(number) == before) return;
    if (is_text_) return text_.replace(raw, std::to_string(number));
    if (size_of(type) == 1)
      put_binary(raw, static_cast<std::uint8_t>(number));
    else if (size_of(type) == 2)
      put_binary(raw, static_cast<std::uint16_t>(number));
    else
      put_binary(raw, number);
  }

  template <class Number>
  void put_binary(std::string_view raw, Number number) {
    put_number(bytes_.data() + (raw.data() - bytes_.data()), number, is_swapped());
  }

  bool is_swapped() const { return (format_ == PlyLayout::Format::big_endian) != is_big_endian_machine(); }

  std::string& bytes_;
  PlyLayout::Format format_;
  bool is_text_;
  const Write& write_;
  TextSplicer text_;
  std::vector<std::tuple<std::size_t, std::size_t, std::string>> header_;  // of binary files: where, how long, by what
};

class PlySplicer {
 public:
  PlySplicer(std::string& bytes, const SpliceInput& input, const std::filesystem::path& out, const Write& write)
      : bytes_(bytes),
        input_(input),
        out_(out),
        mesh_(input.file.mesh),
        layout_(parse_ply_header(bytes, input.path)),
        numbers_(bytes, layout_.format, write) {}

  void splice() {
    const Element* const vertex = layout_.find("vertex");
    const Element* const face = layout_.find("face");
    check_same_count(input_.path, "vertices", mesh_.vertices(), vertex ? vertex->count : 0);
    if (vertex == nullptr) return numbers_.finish();  // as many as were read: none
    const bool vertex_normals = Roles(*vertex, known_of_vertex).has_normal();
    const bool face_normals = face && face->count > 0 && Roles(*face, known_of_face).has_normal();
    if (vertex_normals || face_normals) find_moved(*vertex);
    if (vertex_normals) renew_vertex_normals();
    put_texture_names();
    PlyData data(bytes_, layout_, input_.path);
    std::size_t left = face_normals ? 2 : 1;  // elements with numbers to replace
    for (const Element& element : layout_.elements) {
      const bool is_vertex = &element == vertex, is_face = &element == face && face_normals;
      const Roles roles = is_vertex ? Roles(element, known_of_vertex) : Roles(element, known_of_face);
      if (data.has_fixed_rows(element) && (!is_vertex || (!vertex_normals && !input_.recolored)) && !is_face) {
        const PlyData::FixedRows rows = data.take_fixed_rows(element);
        if (is_vertex) put_positions(element, roles, rows);
      } else {
        for (std::size_t i = 0; i < element.count; ++i) {
          data.read(element, i, row_);
          if (is_vertex) put_vertex(element, roles, i);
          if (is_face) put_face_normal(element, roles);
        }
      }
      if ((is_vertex || is_face) && --left == 0) break;
    }
    numbers_.finish();
  }

 private:
  /// The numbers of three roles in a row, those that are not there as 0.
  Point3d point(const Roles& roles, Role first) const {
    Point3d p(0, 0, 0);
    for (std::size_t i = 0; i < row_.number.size(); ++i) {
      const int k = static_cast<int>(roles[i]) - static_cast<int>(first);
      if (k >= 0 && k < 3) p[k] = row_.number[i];
    }
    return p;
  }

  /// What the vertices were, where they were.
  void find_moved(const Element& vertex) {
    const Roles roles(vertex, known_of_vertex);
    PlyData data(bytes_, layout_, input_.path);
    for (const Element& element : layout_.elements) {
      for (std::size_t i = 0; i < element.count; ++i) {
        data.read(element, i, row_);
        if (&element != &vertex) continue;
        Point3d now = mesh_.position[i];
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
          const int k = static_cast<int>(roles[p]) - static_cast<int>(Role::x);
          if (k >= 0 && k < 3) now[k] = as_stored(now[k], element.properties[p].type);
        }
        vertices_.add(point(roles, Role::x), now);
        old_normals_.push_back(point(roles, Role::nx));
      }
      if (&element == &vertex) return;
    }
  }

  void put_texture_names() {
    for (const std::string_view name : texture_names(layout_))
      numbers_.replace_in_header(name, moved_file_name(name, input_.path.parent_path(), out_.parent_path()));
  }

  void renew_vertex_normals() {
    normals_.emplace(mesh_, vertices_, old_normals_);
    normals_->add_triangles();
    normals_->finish();
  }

  void put_vertex(const Element& element, const Roles& roles, std::size_t index) {
    const std::optional<Point3d> normal = normals_ ? normals_->normal(index) : std::nullopt;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Role role = roles[p];
      switch (role) {
        case Role::x:
        case Role::y:
        case Role::z:
          put_coordinate(element, p, mesh_.position.number(index, static_cast<int>(role) - static_cast<int>(Role::x)));
          break;
        case Role::nx:
        case Role::ny:
        case Role::nz:
          if (normal) put(element, p, (*normal)[static_cast<int>(role) - static_cast<int>(Role::nx)]);
          break;
        default:
          if (input_.recolored) put_color(element, p, role, index);
      }
    }
  }

  /// Of binary rows of one size, where nothing but the positions changes.
  void put_positions(const Element& element, const Roles& roles, const PlyData::FixedRows& rows) {
    const char* first = rows.begin;
    for (const PlyLayout::Property& property : element.properties) {
      const auto p = static_cast<std::size_t>(&property - element.properties.data());
      const int k = static_cast<int>(roles[p]) - static_cast<int>(Role::x);
      if (k >= 0 && k < 3)
        visit_type(property.type, [&](auto number) {
          numbers_.replace_all(first, rows.stride, element.count, number,
                               [&](std::size_t i) { return mesh_.position.number(i, k); });
        });
      first += size_of(property.type);
    }
  }

  void put_coordinate(const Element& element, std::size_t property, double now) {
    if (is_whole(element.properties[property].type) && row_.number[property] != now) refuse_whole_numbers();
    put(element, property, now);
  }

  void put_color(const Element& element, std::size_t property, Role role, std::size_t index) {
    const double before = row_.number[property];
    switch (role) {
      case Role::quality: {
        // The filter has seen it in the precision of the positions.
        const bool single = input_.file.precision == Precision::single_precision;
        const double now = mesh_.vertex_quality[index];
        if (!single || static_cast<float>(before) != static_cast<float>(now)) put(element, property, now);
        break;
      }
      case Role::red:
      case Role::green:
      case Role::blue:
      case Role::alpha:
        if (mesh_.vertex_color.empty()) return;  // a single component is no colour to write
        if (const unsigned char now = mesh_.vertex_color[index][static_cast<int>(role) - static_cast<int>(Role::red)];
            true) {
          const double scale = element.properties[property].type == Type::uint8 ? 1 : input_.file.color_scale;
          if (color_byte(scale * before) != now) put(element, property, now / scale);
        }
        break;
      case Role::gray:
        if (const unsigned char now = mesh_.vertex_color[index][0]; color_byte(255 * before) != now)
          put(element, property, now / 255.0);
        break;
      default:
        break;
    }
  }

  void put_face_normal(const Element& element, const Roles& roles) {
    const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
    if (list == element.properties.end()) return;
    corners_.clear();
    bool moved = false;
    for (const double index : row_.list[static_cast<std::size_t>(list - element.properties.begin())]) {
      if (!(index >= 0 && index < static_cast<double>(mesh_.vertices()))) return;
      corners_.push_back(static_cast<std::uint32_t>(index));
      moved |= vertices_.moved[corners_.back()];
    }
    if (!moved) return;
    const Point3d normal = polygon_normal(mesh_, corners_);
    if (normal == Point3d(0, 0, 0)) return;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const int k = static_cast<int>(roles[p]) - static_cast<int>(Role::nx);
      if (k >= 0 && k < 3) put(element, p, normal[k]);
    }
  }

  void put(const Element& element, std::size_t property, double now) {
    numbers_.replace(row_.raw[property], element.properties[property].type, row_.number[property], now);
  }

  std::string& bytes_;
  const SpliceInput& input_;
  const std::filesystem::path& out_;
  const FlatMesh& mesh_;
  PlyLayout layout_;
  PlyNumbers numbers_;
  PlyData::Row row_;
  MovedVertices vertices_;
  std::vector<Point3d> old_normals_;
  std::optional<MovedNormals> normals_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

void splice_ply(std::string& bytes, const SpliceInput& input, const std::filesystem::path& out, const Write& write) {
  PlySplicer(bytes, input, out, write).splice();
}

}  // namespace mesh_tools::io
