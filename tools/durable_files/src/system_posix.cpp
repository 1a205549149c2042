// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include <durable_files/access.h>
#include <durable_files/replace_file.h>

#include "system.h"

namespace durable_files {
namespace fs = std::filesystem;
namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }
std::error_code error_unless(bool done) { return done ? std::error_code() : last_error(); }

std::error_code check_access(const fs::path& path, int mode) { return error_unless(::access(path.c_str(), mode) == 0); }

}  // namespace

namespace system {

int create(const fs::path& path, const fs::path& replaced, std::error_code& error) {
  struct stat old = {};
  const bool replaces = ::stat(replaced.c_str(), &old) == 0 && S_ISREG(old.st_mode);
  // From the first byte on nobody may read the file who may not read the old one.
  const mode_t mode = replaces ? old.st_mode & 0777 : 0666;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  error = error_unless(file >= 0);
  if (file >= 0 && replaces) (void)::fchmod(file, old.st_mode & 07777);  // what the umask has taken away
  return file;
}

const bool replaces_open_files = true;

int open(const fs::path& path, std::error_code& error) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  error = error_unless(file >= 0);
  return file;
}

InputFile::State state_of(int file, std::error_code& error) {
  struct stat status = {};
  error = error_unless(::fstat(file, &status) == 0);
  return {S_ISREG(status.st_mode), static_cast<std::uint64_t>(status.st_size),
          std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

std::size_t read(int file, std::uint64_t offset, char* bytes, std::size_t count, std::error_code& error) {
  ssize_t got = 0;
  do {
    got = ::pread(file, bytes, count, static_cast<off_t>(offset));
  } while (got < 0 && errno == EINTR);
  error = error_unless(got >= 0);
  return got < 0 ? 0 : static_cast<std::size_t>(got);
}

std::error_code write(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return last_error();
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

std::error_code flush(int file) {
  return error_unless(::fsync(file) == 0 || errno == EINVAL || errno == EOPNOTSUPP || errno == ENOSYS);
}

std::error_code close(int file) { return error_unless(::close(file) == 0); }

std::error_code flush(const fs::path& path, const fs::path& replaced) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return last_error();
  struct stat old = {};
  if (::stat(replaced.c_str(), &old) == 0) (void)::fchmod(file, old.st_mode & 07777);
  const std::error_code error = flush(file);
  ::close(file);
  return error;
}

std::error_code rename(const fs::path& from, const fs::path& to) {
  return error_unless(std::rename(from.c_str(), to.c_str()) == 0);
}

}  // namespace system

void flush_folder(const fs::path& folder) {
  // A folder that one may write to but not read cannot be opened; then the rename alone has to do.
  const int opened = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  (void)system::flush(opened);
  ::close(opened);
}

std::error_code check_readable(const fs::path& file) { return check_access(file, R_OK); }
std::error_code check_writable(const fs::path& file) { return check_access(file, W_OK); }
std::error_code check_folder_writable(const fs::path& folder) { return check_access(folder, W_OK | X_OK); }

}  // namespace durable_files
