// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <mesh_tools/mesh_io.h>

#include "formats.h"

namespace mesh_tools {
namespace {

struct stat status_of(int descriptor, const std::filesystem::path& path) {
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0) io::fail(path, std::string("cannot be read: ") + std::strerror(errno));
  return status;
}

}  // namespace

SourceFile::SourceFile(std::filesystem::path path) : path_(std::move(path)) {
  // Not blocking: of anything but a regular file nothing is read, nor waited for.
  const int descriptor = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) io::fail(path_, std::string("cannot be read: ") + std::strerror(errno));
  descriptor_ = {new int(descriptor), [](const int* open) {
                   ::close(*open);
                   delete open;
                 }};
  const struct stat status = status_of(descriptor, path_);
  if (!S_ISREG(status.st_mode)) io::fail(path_, "cannot be read: it is not a regular file");
  size_ = static_cast<std::uint64_t>(status.st_size);
  seconds_ = status.st_mtim.tv_sec;
  nanoseconds_ = status.st_mtim.tv_nsec;
}

std::string SourceFile::read() const {
  std::string bytes;
  bytes.resize(size_);
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t got = ::pread(*descriptor_, bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) io::fail(path_, "could not be read to its end");
    at += static_cast<std::size_t>(got);
  }
  return bytes;
}

bool SourceFile::has_changed() const {
  const struct stat status = status_of(*descriptor_, path_);
  return static_cast<std::uint64_t>(status.st_size) != size_ || status.st_mtim.tv_sec != seconds_ ||
         status.st_mtim.tv_nsec != nanoseconds_;
}

}  // namespace mesh_tools
