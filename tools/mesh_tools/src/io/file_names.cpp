// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_names.h"

#include <algorithm>
#include <system_error>

namespace mesh_tools::io {
namespace {

namespace fs = std::filesystem;

/// With the separators of this system: files that were made on Windows have others.
fs::path as_path(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  return text;
}

class Mover {
 public:
  Mover(const fs::path& from_folder, const fs::path& to_folder)
      : from_(from_folder.empty() ? "." : from_folder), to_(to_folder.empty() ? "." : to_folder) {}

  bool is_needed() const {
    std::error_code error;
    return !fs::equivalent(from_, to_, error) && !error;
  }

  bool is_file(std::string_view name) const {
    std::error_code error;
    return fs::is_regular_file(from_ / as_path(name), error);
  }

  std::string moved(std::string_view name) const {
    const fs::path path = as_path(name);
    std::error_code error;
    if (path.is_absolute()) return std::string(name);
    const fs::path folder = fs::relative((from_ / path).parent_path(), to_, error);
    if (error || folder.empty()) return std::string(name);
    const std::string result = (folder / path.filename()).lexically_normal().generic_string();
    const auto is_control = [](unsigned char c) { return c < ' '; };  // of a folder: no text format could hold it
    return std::any_of(result.begin(), result.end(), is_control) ? std::string(name) : result;
  }

 private:
  fs::path from_, to_;
};

}  // namespace

std::string moved_file_name(std::string_view name, const fs::path& from_folder, const fs::path& to_folder) {
  const Mover mover(from_folder, to_folder);
  return !name.empty() && mover.is_needed() && mover.is_file(name) ? mover.moved(name) : std::string(name);
}

std::string moved_material_names(std::string_view names, const fs::path& from_folder, const fs::path& to_folder) {
  const Mover mover(from_folder, to_folder);
  if (names.empty() || !mover.is_needed()) return std::string(names);
  constexpr const char* blanks = " \t\r\v\f";
  const bool is_one = names.find_first_of(blanks) == std::string_view::npos;
  if (is_one || mover.is_file(names)) return mover.moved(names);
  std::string result;
  for (std::size_t at = 0; at < names.size();) {
    const std::size_t start = names.find_first_not_of(blanks, at);
    if (start == std::string_view::npos) return result.append(names.substr(at));
    const std::size_t end = std::min(names.find_first_of(blanks, start), names.size());
    const std::string_view name = names.substr(start, end - start);
    result.append(names.substr(at, start - at)).append(mover.is_file(name) ? mover.moved(name) : std::string(name));
    at = end;
  }
  return result;
}

}  // namespace mesh_tools::io
