// SPDX-License-Identifier: GPL-3.0-or-later
#include "obj_materials.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

#include "colors.h"
#include "formats.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string_view>;

/// A name that may hold spaces: the words from `first` on; nothing if there are none.
std::string name_of(const Words& words, std::size_t first = 1) {
  if (first >= words.size()) return {};
  std::string name(words[first]);
  for (std::size_t i = first + 1; i < words.size(); ++i) name.append(" ").append(words[i]);
  return name;
}

/// The words before one that begins with '#', which may be a comment.
Words without_comment(const Words& words) {
  const auto comment =
      std::find_if(words.begin() + 1, words.end(), [](std::string_view word) { return word[0] == '#'; });
  return {words.begin(), comment};
}

bool is_number(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

/// Where the name begins in a texture's statement, behind options such as "-s 2 2 1"; the count of words if nowhere.
std::size_t after_options(const Words& words) {
  struct Option {
    std::string_view name;
    std::size_t fewest, most;  // of arguments; those beyond the fewest are numbers
  };
  static constexpr Option options[] = {{"-blendu", 1, 1}, {"-blendv", 1, 1}, {"-boost", 1, 1},   {"-mm", 2, 2},
                                       {"-o", 1, 3},      {"-s", 1, 3},      {"-t", 1, 3},       {"-texres", 1, 1},
                                       {"-clamp", 1, 1},  {"-bm", 1, 1},     {"-imfchan", 1, 1}, {"-type", 1, 1},
                                       {"-cc", 1, 1}};
  std::size_t at = 1;
  while (at < words.size()) {
    const auto option = std::find_if(std::begin(options), std::end(options),
                                     [&](const Option& candidate) { return candidate.name == words[at]; });
    if (option == std::end(options)) break;
    std::size_t taken = 0;
    for (++at; at < words.size() && taken < option->most; ++at, ++taken)
      if (taken >= option->fewest && !is_number(words[at])) break;
  }
  return at;
}

/// The opacity that `d` and `Tr` give. Tr is 1 - d, but some programs wrote what they called Tr the other way round: a
/// Tr alone of 0 or 1 makes nothing invisible.
double opacity(const std::optional<double>& d, const std::optional<double>& tr) {
  if (d) return *d;
  return tr && *tr > 0 && *tr < 1 ? 1 - *tr : 1;
}

}  // namespace

int ObjMaterials::page_of(const std::string& name) {
  const auto [entry, is_new] = page_of_.try_emplace(name, static_cast<int>(textures_.size()));
  if (is_new) textures_.push_back(name);
  return entry->second;
}

void ObjMaterials::add_libraries(const Words& words) {
  const auto is_file = [&](const std::string& name) {
    std::error_code error;
    return fs::is_regular_file(folder_ / name, error);
  };
  const std::string whole = name_of(words), before_comment = name_of(without_comment(words));
  if (is_file(whole)) return add_library(whole);
  if (before_comment != whole && is_file(before_comment)) return add_library(before_comment);
  const bool is_list =
      std::any_of(words.begin() + 1, words.end(), [&](auto word) { return is_file(std::string(word)); });
  if (!is_list) return add_library(whole);
  for (const std::string_view word : without_comment(words))
    if (word.data() != words[0].data()) add_library(std::string(word));
}

void ObjMaterials::add_library(const fs::path& name) {
  try {
    read_library(name);
  } catch (const FileError& error) {
    problems.push_back(std::string(error.what()) + " (colours and textures are lost)");
  }
}

void ObjMaterials::read_library(const fs::path& name) {
  const fs::path path = folder_ / name;
  const std::string text = SourceFile(path).read();
  LineReader reader(text, path, Comments::outside_names);
  std::size_t odd_entries = 0;
  std::optional<double> d, tr;
  Words words;
  const auto take = [&](Material& material) {
    if (words[0] == "Kd" && words.size() >= 4) {
      const double part[3] = {reader.number(words[1]), reader.number(words[2]), reader.number(words[3])};
      for (int k = 0; k < 3; ++k) material.color[k] = color_byte(255 * part[k]);
    } else if (words[0] == "d") {
      d = reader.number(words[words[1] == "-halo" && words.size() > 2 ? 2 : 1]);
    } else if (words[0] == "Tr") {
      tr = reader.number(words[1]);
    } else if (words[0] == "map_Kd") {
      const std::size_t first = after_options(words);
      if (first == words.size()) return;
      const fs::path folder = name.parent_path();
      const std::string texture = name_of(words, first);
      material.page = page_of(folder.empty() ? texture : (folder / texture).generic_string());
    }
    material.color[3] = color_byte(255 * opacity(d, tr));
  };
  while (reader.next(words)) {
    if (words.size() < 2) continue;
    if (words[0] == "newmtl") {
      d.reset();
      tr.reset();
      material_of_[name_of(words)] = static_cast<int>(materials_.size());
      materials_.push_back({name_of(words)});
    } else if (!materials_.empty()) {
      try {
        take(materials_.back());
      } catch (const FileError& error) {
        if (odd_entries++ == 0) problems.push_back(std::string(error.what()) + " (this entry is passed over)");
      }
    }
  }
}

int ObjMaterials::find(const Words& words) const {
  if (words.size() < 2) return -1;
  auto known = material_of_.find(name_of(words));
  if (known == material_of_.end() && words[1][0] != '#') known = material_of_.find(name_of(without_comment(words)));
  return known == material_of_.end() ? -1 : known->second;
}

}  // namespace mesh_tools::io
