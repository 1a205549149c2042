// SPDX-License-Identifier: GPL-3.0-or-later
#include <durable_files/replace_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "flush.h"

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
  fail(path, std::strerror(ELOOP));
}

void replace_file(const fs::path& from, const fs::path& to) {
  const int file = ::open(from.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) fail(to, std::strerror(errno));
  struct stat old = {};
  const bool replaces = ::stat(to.c_str(), &old) == 0;
  if (replaces) (void)::fchmod(file, old.st_mode & 07777);
  const int error = flush(file) ? 0 : errno;
  ::close(file);
  if (error != 0) fail(to, std::strerror(error));
  if (std::rename(from.c_str(), to.c_str()) != 0) fail(to, std::strerror(errno));
  flush_folder(to.parent_path());
}

void flush_folder(const fs::path& folder) {
  // A folder that one may write to but not read cannot be opened; then the rename alone has to do.
  const int opened = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  flush(opened);
  ::close(opened);
}

}  // namespace durable_files
