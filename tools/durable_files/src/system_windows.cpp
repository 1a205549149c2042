// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>

#include <durable_files/access.h>
#include <durable_files/replace_file.h>

#include "system.h"

namespace durable_files {
namespace fs = std::filesystem;
namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }
std::error_code error_unless(bool done) { return done ? std::error_code() : last_error(); }

std::error_code check_access(const fs::path& path, int mode) {
  return error_unless(::_waccess(path.c_str(), mode) == 0);
}

}  // namespace

namespace system {

// A new file has the permissions of its folder; a file that may not be written to is not replaced.
int create(const fs::path& path, const fs::path& /*replaced*/, std::error_code& error) {
  const int file =
      ::_wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
  error = error_unless(file >= 0);
  return file;
}

std::error_code write(int file, std::string_view bytes) {
  constexpr std::size_t most_at_once = 1 << 30;  // Windows counts the bytes of a call in 32 bits
  while (!bytes.empty()) {
    const int written = ::_write(file, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), most_at_once)));
    if (written < 0) return last_error();
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

std::error_code flush(int file) { return error_unless(::_commit(file) == 0); }

std::error_code close(int file) { return error_unless(::_close(file) == 0); }

std::error_code flush(const fs::path& path, const fs::path& /*replaced*/) {
  const int file = ::_wopen(path.c_str(), _O_RDWR | _O_BINARY | _O_NOINHERIT);
  if (file < 0) return last_error();
  const std::error_code error = flush(file);
  ::_close(file);
  return error;
}

std::error_code rename(const fs::path& from, const fs::path& to) {
  if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) return {};
  return {static_cast<int>(::GetLastError()), std::system_category()};
}

}  // namespace system

void flush_folder(const fs::path& /*folder*/) {
}  // Windows has no such thing; MOVEFILE_WRITE_THROUGH waits for the name

// Modes of _waccess, which have no names: 2 asks whether the file may be written to, 4 whether it may be read.
std::error_code check_readable(const fs::path& file) { return check_access(file, 4); }
std::error_code check_writable(const fs::path& file) { return check_access(file, 2); }
std::error_code check_folder_writable(const fs::path& folder) { return check_access(folder, 2); }

}  // namespace durable_files
