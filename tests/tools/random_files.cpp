// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_files.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <type_traits>

#include <mesh_tools/random.h>

namespace tools_tests {
namespace {

using vcg::Point3d;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(count * random_.uniform()));
  }
  bool is(double probability) { return random_.uniform() < probability; }
  double uniform() { return random_.uniform(); }
  std::string one_of(std::initializer_list<const char*> words) { return words.begin()[below(words.size())]; }

  template <class Item>
  void shuffle(std::vector<Item>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  mesh_tools::Random random_;
};

template <class Real>
std::string shortest(Real value) {
  char digits[64];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// In one of the ways that programs write numbers.
std::string odd(Dice& dice, double value) {
  char digits[64];
  const char* const formats[] = {"%.17g", "%.17e", "%+.20f", "%.17G"};
  std::snprintf(digits, sizeof digits, formats[dice.below(4)], value);
  return digits;
}

template <class Real>
std::string number(Dice& dice, double before, double now) {
  const std::string text = odd(dice, before);  // the dice fall alike in both files
  return before == now ? text : shortest(static_cast<Real>(now));
}

std::vector<std::size_t> random_face(Dice& dice, std::size_t vertices) {
  std::vector<std::size_t> face(vertices);
  std::iota(face.begin(), face.end(), 0);
  dice.shuffle(face);
  face.resize(3 + dice.below(std::min<std::size_t>(3, vertices - 2)));
  return face;
}

// PLY

struct Type {
  const char* name;
  std::size_t size;
  bool whole;
};
constexpr Type types[] = {{"char", 1, true},   {"uint8", 1, true},    {"short", 2, true},
                          {"uint16", 2, true}, {"int32", 4, true},    {"uint", 4, true},
                          {"float", 4, false}, {"float32", 4, false}, {"double", 8, false}};
constexpr Type real_types[] = {{"float", 4, false}, {"float64", 8, false}};

struct Property {
  std::string name;
  Type type;
  bool is_list;
  Type count_type;
};

class PlyText {
 public:
  PlyText(std::uint64_t seed, const Places& places) : dice_(seed), places_(places) {
    form_ = dice_.below(3);
    end_of_line_ = dice_.one_of({"\n", "\r\n"});
  }

  std::string bytes() {
    std::vector<std::string> elements = {"vertex", "face", "mark", "nothing"};
    dice_.shuffle(elements);
    const char* const forms[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    line("ply");
    line(std::string("format ") + forms[form_] + " 1.0");
    const Type real = real_types[dice_.below(2)];
    std::string body;
    for (const std::string& element : elements) {
      if (dice_.is(0.5)) line(dice_.one_of({"comment made by hand", "obj_info a scanner", "comment", "comment  x "}));
      std::vector<Property> properties = extra_properties();
      if (element == "vertex")
        for (const char* axis : {"x", "y", "z"}) properties.push_back({axis, real, false, types[1]});
      if (element == "face")
        properties.push_back(
            {dice_.one_of({"vertex_indices", "vertex_index"}), types[2 + dice_.below(4)], true, types[1]});
      dice_.shuffle(properties);
      const std::size_t count = element == "vertex" ? places_.before.size() : element == "nothing" ? 0 : dice_.below(4);
      line("element " + element + " " + std::to_string(count));
      for (const Property& property : properties)
        line("property " + (property.is_list ? std::string("list ") + property.count_type.name + " " : std::string()) +
             property.type.name + " " + property.name);
      for (std::size_t row = 0; row < count; ++row) append_row(body, properties, row);
    }
    line("end_header");
    return head_ + body + (dice_.is(0.3) ? "bytes behind the end" : "");
  }

 private:
  void line(const std::string& text) { head_ += text + end_of_line_; }

  std::vector<Property> extra_properties() {
    std::vector<Property> properties;
    for (std::size_t i = dice_.below(4) + 1; i > 0; --i)
      properties.push_back({"extra" + std::to_string(i), types[dice_.below(9)], dice_.is(0.3), types[dice_.below(6)]});
    return properties;
  }

  void append_row(std::string& body, const std::vector<Property>& properties, std::size_t row) {
    for (const Property& property : properties) {
      const std::size_t axis = property.name.size() == 1 ? static_cast<std::size_t>(property.name[0] - 'x') : 3;
      if (axis < 3) {
        append_coordinate(body, property.type, places_.before[row][static_cast<int>(axis)],
                          places_.now[row][static_cast<int>(axis)]);
      } else if (!property.is_list) {
        append(body, property.type, static_cast<double>(dice_.below(100)));
      } else {
        std::vector<std::size_t> entries(dice_.below(4), 7);
        if (property.name[0] == 'v') entries = random_face(dice_, places_.before.size());
        append(body, property.count_type, static_cast<double>(entries.size()));
        for (const std::size_t entry : entries) append(body, property.type, static_cast<double>(entry));
      }
    }
    if (form_ == 0) body += dice_.one_of({"\n", "\r\n", " \n", "\n\n"});
  }

  void append_coordinate(std::string& body, Type type, double before, double now) {
    if (form_ != 0) return append(body, type, now);
    body += type.size == 4 ? number<float>(dice_, before, now) : number<double>(dice_, before, now);
    body += dice_.one_of({" ", "  ", "\t", "\n"});
  }

  void append(std::string& body, Type type, double value) {
    if (form_ == 0) {
      body += (type.whole ? std::to_string(static_cast<int>(value)) : odd(dice_, value + 0.1)) + " ";
      return;
    }
    char raw[8];
    const auto put = [&](auto number) { std::memcpy(raw, &number, sizeof number); };
    if (type.whole)
      put(static_cast<std::uint64_t>(value));  // the lowest bytes come first
    else if (type.size == 4)
      put(static_cast<float>(value));
    else
      put(value);
    if (form_ == 2) std::reverse(raw, raw + type.size);
    body.append(raw, type.size);
  }

  Dice dice_;
  const Places& places_;
  std::size_t form_;
  std::string end_of_line_, head_;
};

}  // namespace

std::string random_ply(std::uint64_t seed, const Places& places) { return PlyText(seed, places).bytes(); }

std::string random_obj(std::uint64_t seed, const Places& places) {
  Dice dice(seed);
  const std::string end = dice.one_of({"\n", "\r\n"});
  std::string text;
  for (std::size_t v = 0; v < places.before.size(); ++v) {
    while (dice.is(0.4))
      text += dice.one_of({"# v 1 2 3", "g a b", "s off", "", "o thing", "vt 0 1", "# ends in a backslash \\", "p 1",
                           "usemtl m", "vp 1 2", "curv 0 1 1 2", "  "}) +
              end;
    text += dice.one_of({"v ", "  v\t", "v  "});
    for (int k = 0; k < 3; ++k)
      text += number<double>(dice, places.before[v][k], places.now[v][k]) + dice.one_of({" ", "\t", " \\\n ", "  "});
    text += dice.one_of({"", "1.0", "0.25 0.5 1", "1 2 3 # 4", "# v 1 2 3"}) + end;
    if (v < 2 || !dice.is(0.5)) continue;
    text += "f";
    const bool from_here = dice.is(0.5);
    for (const std::size_t corner : random_face(dice, v + 1))
      text += " " + (from_here ? std::to_string(static_cast<int>(corner) - static_cast<int>(v) - 1)
                               : std::to_string(corner + 1));
    text += end;
  }
  return text + "f 1 2 3" + (dice.is(0.5) ? end : "");
}

std::string random_off(std::uint64_t seed, const Places& places) {
  Dice dice(seed);
  const bool colors = dice.is(0.5), texture = dice.is(0.3);
  const std::string end = dice.one_of({"\n", "\r\n"});
  std::string text = std::string(dice.is(0.5) ? "# a comment" + end : "") + (texture ? "ST" : "") +
                     (colors ? "C" : "") + "OFF" + (dice.is(0.3) ? " " : end);
  const std::size_t faces = 1 + dice.below(4);
  text += std::to_string(places.before.size()) + "  " + std::to_string(faces) + dice.one_of({" 0", "", " 7"}) + end;
  for (std::size_t v = 0; v < places.before.size(); ++v) {
    text += dice.one_of({"", " ", "# 1 2 3\n", "\n"});
    for (int k = 0; k < 3; ++k)
      text += number<double>(dice, places.before[v][k], places.now[v][k]) + dice.one_of({" ", "\t", "  "});
    if (colors) text += dice.one_of({"1 2 3", "0.5 0.25 0.125 1.0", "255 0 7 9"});
    text += (texture ? " 0.5 0.25" : "") + dice.one_of({"", " # 1 2", " "}) + end;
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const std::vector<std::size_t> face = random_face(dice, places.before.size());
    text += std::to_string(face.size());
    for (const std::size_t corner : face) text += " " + std::to_string(corner);
    text += dice.one_of({"", " 1 2 3", " 0.5 0.5 0.5 # red"}) + end;
  }
  return text + (dice.is(0.3) ? "more 1 2 3" : "");
}

std::string random_stl(std::uint64_t seed, const Places& places) {
  Dice dice(seed);
  const std::string end = dice.one_of({"\n", "\r\n"});
  std::string text = dice.one_of({"solid", "solid vertex 1 2 3", "solid a name"}) + end;
  for (std::size_t f = 3 + dice.below(5); f > 0; --f) {
    text += dice.one_of({"facet normal 0 0 0", "  facet  normal 0 0 0"}) + end + "outer loop" + end;
    std::vector<std::size_t> face = random_face(dice, places.before.size());
    face.resize(3);
    for (const std::size_t v : face) {
      text += dice.one_of({"vertex ", "\tvertex\t"});
      for (int k = 0; k < 3; ++k)
        text += number<float>(dice, places.before[v][k], places.now[v][k]) + dice.one_of({" ", "  "});
      text += end;
    }
    text += "endloop" + end + "endfacet" + end;
    if (dice.is(0.1)) text += "endsolid" + end + "solid again" + end;
  }
  return text + "endsolid" + end;
}

Places random_places(std::uint64_t seed, std::size_t count) {
  Dice dice(seed);
  Places places;
  const auto exact = [&] { return static_cast<double>(static_cast<float>(200 * dice.uniform() - 100)); };
  for (std::size_t v = 0; v < count; ++v) {
    places.before.emplace_back(exact(), exact(), exact());
    places.now.push_back(places.before.back());
    for (int k = 0; k < 3; ++k)
      if (dice.is(0.3)) places.now.back()[k] = exact();
  }
  return places;
}

}  // namespace tools_tests
