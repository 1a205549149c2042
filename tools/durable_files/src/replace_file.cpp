// SPDX-License-Identifier: GPL-3.0-or-later
#include <durable_files/replace_file.h>

#include <string>
#include <system_error>

#include "system.h"

namespace durable_files {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw WriteError(path.string() + ": cannot be written: " + what);
}

}  // namespace

fs::path final_target(const fs::path& path) {
  constexpr int most_links = 40;  // as the system's own limit
  fs::path target = path;
  for (int links = 0; links < most_links; ++links) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(target, error).type();
    if (type == fs::file_type::none) fail(path, error.message());
    if (type != fs::file_type::symlink) return target;
    const fs::path link = fs::read_symlink(target, error);
    if (error) fail(path, error.message());
    target = link.is_absolute() ? link : target.parent_path() / link;
  }
  fail(path, std::make_error_code(std::errc::too_many_symbolic_link_levels).message());
}

void replace_file(const fs::path& from, const fs::path& to) {
  if (const std::error_code error = system::flush(from, to)) fail(to, error.message());
  if (const std::error_code error = system::rename(from, to)) fail(to, error.message());
  flush_folder(to.parent_path());
}

}  // namespace durable_files
