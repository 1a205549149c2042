// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_file.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "fail.h"

namespace tiles {

InputFile::InputFile(const std::filesystem::path& path) try : file_(path) {
  if (!file_.state().is_regular) fail(path, "is not a regular file");
} catch (const std::system_error& error) {
  fail(path, "cannot be read: " + error.code().message());
}

void InputFile::read(std::uint64_t offset, void* bytes, std::size_t count) const {
  std::size_t got = 0;
  try {
    got = file_.read(offset, bytes, count);
  } catch (const std::system_error& error) {
    fail(path(), "cannot be read: " + error.code().message());
  }
  if (got < count) fail(path(), "is cut off: it ends at byte " + std::to_string(offset + got));
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
