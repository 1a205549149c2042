// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "fail.h"

namespace tiles {
InputFile::InputFile(const std::filesystem::path& path) : path_(path) {
  struct stat state = {};
  file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const int error = file_ < 0 || ::fstat(file_, &state) != 0 ? errno : 0;
  if (error == 0 && S_ISREG(state.st_mode)) {
    size_ = static_cast<std::uint64_t>(state.st_size);
    modified_ = std::int64_t{state.st_mtim.tv_sec} * 1'000'000'000 + state.st_mtim.tv_nsec;
    return;
  }
  if (file_ >= 0) ::close(file_);
  fail(path, error != 0 ? std::string("cannot be read: ") + std::strerror(error) : "is not a regular file");
}

InputFile::~InputFile() { ::close(file_); }

void InputFile::read(std::uint64_t offset, void* bytes, std::size_t count) const {
  char* to = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = ::pread(file_, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path_, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) fail(path_, "is cut off: it ends at byte " + std::to_string(offset));
    to += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

SequentialReader::SequentialReader(const InputFile& file, std::uint64_t begin, std::uint64_t end, std::size_t buffer)
    : file_(file), next_(begin), end_(end), buffer_(buffer) {}

const char* SequentialReader::take(std::size_t count) {
  if (filled_ - used_ < count) fill(count);
  const char* const bytes = buffer_.data() + used_;
  used_ += count;
  return bytes;
}

std::size_t SequentialReader::take_some(const char*& bytes, std::size_t most) {
  if (filled_ == used_ && next_ < end_) fill(1);
  const std::size_t count = std::min(most, filled_ - used_);
  bytes = buffer_.data() + used_;
  used_ += count;
  return count;
}

void SequentialReader::fill(std::size_t least) {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(used_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(filled_), buffer_.begin());
  filled_ -= used_;
  used_ = 0;
  if (buffer_.size() < least) buffer_.resize(least);
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(buffer_.size() - filled_, end_ - next_));
  if (filled_ + count < least) fail(file_.path(), "is cut off: it ends at byte " + std::to_string(end_));
  file_.read(next_, buffer_.data() + filled_, count);
  filled_ += count;
  next_ += count;
}

}  // namespace tiles
