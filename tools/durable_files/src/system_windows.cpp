// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>

#include <durable_files/access.h>
#include <durable_files/replace_file.h>

#include "system.h"

namespace durable_files {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_at_once = 1 << 30;  // Windows counts the bytes of a call in 32 bits

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

const bool replaces_open_files = false;

int open(const fs::path& path, std::error_code& error) {
  const int file = ::_wopen(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
  error = error_unless(file >= 0);
  return file;
}

InputFile::State state_of(int file, std::error_code& error) {
  struct _stat64 status = {};
  FILETIME written = {};
  error = error_unless(::_fstat64(file, &status) == 0);
  if (!error && !::GetFileTime(reinterpret_cast<HANDLE>(::_get_osfhandle(file)), nullptr, nullptr, &written))
    written = {};  // of a console, for one
  const auto ticks = static_cast<std::int64_t>(written.dwHighDateTime) << 32 | written.dwLowDateTime;  // of 100 ns
  return {(status.st_mode & _S_IFMT) == _S_IFREG, static_cast<std::uint64_t>(status.st_size), 100 * ticks};
}

std::size_t read(int file, std::uint64_t offset, char* bytes, std::size_t count, std::error_code& error) {
  const bool found = ::_lseeki64(file, static_cast<std::int64_t>(offset), SEEK_SET) >= 0;
  const int got = found ? ::_read(file, bytes, static_cast<unsigned>(std::min(count, most_at_once))) : -1;
  error = error_unless(got >= 0);
  return got < 0 ? 0 : static_cast<std::size_t>(got);
}

std::error_code write(int file, std::string_view bytes) {
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
