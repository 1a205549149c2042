// SPDX-License-Identifier: GPL-3.0-or-later
#include <durable_files/pending_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <utility>

#include "flush.h"

namespace durable_files {
namespace fs = std::filesystem;
namespace {

constexpr const char* cannot_be_written = "cannot be written";
constexpr const char* not_to_its_end = "could not be written to its end";

/// A hidden name beside `target` that nobody can guess.
fs::path unpredictable_name(const fs::path& target) {
  // The whole must not be longer than a name may be, which `target` may be already.
  constexpr std::size_t longest_stem = 200;
  constexpr char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> any(0, sizeof letters - 2);
  std::string name = "." + target.filename().string().substr(0, longest_stem) + ".";
  for (int i = 0; i < 12; ++i) name += letters[any(random)];
  return target.parent_path() / (name + ".part");
}

}  // namespace

PendingFile::PendingFile(const fs::path& path) : path_(path), target_(final_target(path)) {
  struct stat old = {};
  const bool replaces = ::stat(target_.c_str(), &old) == 0 && S_ISREG(old.st_mode);
  // From the first byte on nobody may read the file who may not read the old one.
  const mode_t mode = replaces ? old.st_mode & 0777 : 0666;
  do {
    pending_ = unpredictable_name(target_);
    file_ = ::open(pending_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  } while (file_ < 0 && errno == EEXIST);
  if (file_ < 0) {
    pending_.clear();
    fail(cannot_be_written);
  }
  if (replaces) (void)::fchmod(file_, old.st_mode & 07777);  // what the umask has taken away
}

PendingFile::~PendingFile() {
  if (file_ >= 0) ::close(file_);
  if (!pending_.empty()) ::unlink(pending_.c_str());
}

void PendingFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(not_to_its_end);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void PendingFile::complete() {
  if (!flush(file_)) fail(not_to_its_end);
  if (::close(std::exchange(file_, -1)) != 0) fail(not_to_its_end);
}

void PendingFile::put_in_place() {
  if (std::rename(pending_.c_str(), target_.c_str()) != 0) fail(cannot_be_written);
  pending_.clear();
  flush_folder(target_.parent_path());
}

void PendingFile::fail(const char* what) const {
  throw WriteError(path_.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace durable_files
